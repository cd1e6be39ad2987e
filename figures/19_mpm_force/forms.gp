# forms.gp - one particle hands its stress to nine nodes; and by how much the
# force is wrong when it is written down wrongly.  Forces below 1 N have no arrow.
# Reads   data  tables nodes, particle, forms
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 780,420
set output out
f(x) = sqrt(column("f_x")**2 + column("f_y")**2)
array Torque[4]
do for [k = 1:4] {
    stats data index "forms" every 5::k using "torque" nooutput
    Torque[k] = STATS_max
}
set multiplot
unset grid
set lmargin at screen 0.085
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
set label 1 "particle" at 1.28,1.1 left tc rgb "#0072B2"
set label 2 "force on a node" at 1.1,1.38 left tc rgb "#D55E00"
set label 3 "10 N" at 0.62,1.38 left
set label 4 "below 1 N: not drawn" at 1.8,0.22 right tc rgb "#D55E00"
set arrow 1 from 0.62,1.325 to 0.86,1.325 filled size 0.03,22 fixed lw 1.6 lc rgb "#D55E00"
plot for [j = 0:2] data index "nodes" every ::3*j::3*j+2 using "x":"y" \
         with lines ls 9 lw 1, \
     for [i = 0:2] data index "nodes" every 3::i using "x":"y" \
         with lines ls 9 lw 1, \
     data index "particle" using "x":"y" with filledcurves closed \
         fc rgb "#56B4E9" fs transparent solid 0.5, \
     data index "nodes" using (f(0) < 1 ? NaN : column("x")):"y":(0.024*column("f_x")):(0.024*column("f_y")) \
         with vectors head filled size 0.03,22 fixed lw 1.6 lc rgb "#D55E00", \
     data index "nodes" using "x":"y" with points ls 1 lc rgb "black"
unset label
unset arrow
set size noratio
set lmargin at screen 0.53
set rmargin at screen 0.87
set tmargin at screen 0.86
set xrange [0:92]
set yrange [4.5:0.4]
set xtics 20
unset ytics
set border 1
set xlabel "error of the force (%)"
set ylabel ""
# mistake k: what is written wrongly, and whether a torque is left
array Wrong[4] = ["without (F^n)^T", "with F^T, not (F^n)^T", \
                  "stress of t^n, not the new one", \
                  "volume of t^n, not V^0, before P"]
do for [k = 1:4] {
    set arrow k from 0, k to 92, k nohead ls 9
    set label k Wrong[k] at 0.5, k - 0.33
    set label k + 10 (Torque[k] > 1e-9 ? "yes" : "no") at 101, k center
}
set label 20 "torque\nfinds it" at 101, 0.2 center
set label 21 "linear" at 22, 0.3 center tc ls 1
set label 22 "quadratic" at 44, 0.3 center tc ls 2
set label 23 "cubic kernel" at 70, 0.3 center tc ls 3
plot for [s = 1:3] data index "forms" every ::5*s-4::5*s-1 \
         using (100*column("error")):($0 + 1 + 0.13 * (s - 2)) with points ls s ps 1.2
unset multiplot
