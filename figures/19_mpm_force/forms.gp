# forms.gp - one particle hands its stress to nine nodes; and by how much the
# force is wrong when it is written down wrongly.
# Reads   data  tables nodes, particle, forms
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 940,430
set output out
set multiplot
unset grid
set lmargin at screen 0.075
set rmargin at screen 0.44
set tmargin at screen 0.93
set bmargin at screen 0.12
set size ratio -1
set xrange [0.55:1.85]
set yrange [0.15:1.45]
set xtics 0.4
set ytics 0.4
set xlabel "x (m)"
set ylabel "y (m)"
unset key
set label 1 "particle" at 1.36,0.97 left font ",12"
set label 2 "10 N" at 0.62,1.39 left font ",12"
set arrow 1 from 0.62,1.335 to 0.82,1.335 nohead lw 2 lc rgb "#D55E00"
plot for [j = 0:2] data index "nodes" every ::3*j::3*j+2 using "x":"y" \
         with lines ls 9 lw 1, \
     for [i = 0:2] data index "nodes" every 3::i using "x":"y" \
         with lines ls 9 lw 1, \
     data index "particle" using "x":"y" with filledcurves closed \
         fc rgb "#56B4E9" fs transparent solid 0.5, \
     data index "nodes" using "x":"y":(0.02*column("f_x")):(0.02*column("f_y")) \
         with vectors head filled size 0.035,20 lw 2 lc rgb "#D55E00", \
     data index "nodes" using "x":"y" with points ls 1 lc rgb "black"
unset label
unset arrow
set size noratio
set grid back ls 9
set lmargin at screen 0.56
set rmargin at screen 0.985
set bmargin at screen 0.2
set tmargin at screen 0.86
set style data boxes
set boxwidth 0.26
set style fill solid 0.85 border
set xrange [0.4:4.6]
set yrange [0:100]
set xtics ("{F_n}^T\nforgotten" 1, "F^T in\nits place" 2, "stress of\nt^n" 3, \
    "volume of\nt^n" 4) scale 0
set ytics 20
set xlabel ""
set ylabel "error of the force (%)"
set key above left maxrows 1 samplen 1.5
array Name[3] = ["linear", "quadratic", "cubic"]
set label 1 "turns by\nitself" at 1,61 center font ",12"
set label 2 "turns by\nitself" at 2,33 center font ",12"
set label 3 "turns by\nitself" at 3,97 center font ",12"
set label 4 "balances\nall the same" at 4,33 center font ",12"
plot for [s = 1:3] data index "forms" every ::5*s-4::5*s-1 \
         using ($0 + 1 + 0.28 * (s - 2)):(100*column("error")) ls s title Name[s]
unset multiplot
