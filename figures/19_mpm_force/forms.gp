# forms.gp - one particle hands its stress to nine nodes; and by how much the
# force is wrong when it is written down wrongly (quadratic kernel).  Forces
# below 1.5 N have no arrow.
# Reads   data  tables nodes, particle, forms
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,960 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
f(x) = sqrt(column("f_x")**2 + column("f_y")**2)
orange = "#D55E00"
array Torque[4]
do for [k = 1:4] {
    stats data index "forms" every 5::k using "torque" nooutput
    Torque[k] = STATS_max
}
set multiplot
unset grid
set lmargin at screen 0.2
set rmargin at screen 0.97
set tmargin at screen 0.985
set bmargin at screen 0.515
set size ratio -1
set xrange [0.6:1.75]
set yrange [0.2:1.45]
set xtics 0.4
set ytics 0.4
set xlabel "x (m)"
set ylabel "y (m)"
unset key
set label 1 "particle" at 1.32, 0.68 left tc rgb "#0072B2"
set label 2 "force on\na node" at 1.14, 1.0 right tc rgb orange
set label 3 "10 N" at 0.88, 1.38 left
set arrow 1 from 0.62,1.38 to 0.86,1.38 filled size 0.03,22 fixed lw 1.8 lc rgb orange
plot for [j = 0:2] data index "nodes" every ::3*j::3*j+2 using "x":"y" \
         with lines ls 9 lw 1, \
     for [i = 0:2] data index "nodes" every 3::i using "x":"y" \
         with lines ls 9 lw 1, \
     data index "particle" using "x":"y" with filledcurves closed \
         fc rgb "#56B4E9" fs transparent solid 0.5, \
     data index "nodes" using (f(0) < 1.5 ? NaN : column("x")):"y":(0.024*column("f_x")):(0.024*column("f_y")) \
         with vectors head filled size 0.03,22 fixed lw 1.8 lc rgb orange, \
     data index "nodes" using "x":"y" with points ls 1 lc rgb "black"
unset label
unset arrow
set size noratio
set lmargin at screen 0.05
set rmargin at screen 0.80
set tmargin at screen 0.415
set bmargin at screen 0.09
set xrange [0:92]
set yrange [4.5:0.4]
set xtics 20
unset ytics
set border 1
set xlabel "error of the force, quadratic kernel (%)"
set ylabel ""
# mistake k: what is written wrongly, and whether a torque is left
array Wrong[4] = ["without (F^n)^T", "with F^T, not (F^n)^T", \
                  "stress of t^n, not the new one", \
                  "volume of t^n, not V^0, before P"]
do for [k = 1:4] {
    set arrow k from 0, k to 92, k nohead ls 9
    set label k Wrong[k] at 0.5, k - 0.36
    set label k + 10 (Torque[k] > 1e-9 ? "yes" : "no") at 106, k center
}
set label 20 "torque\nfinds it" at 106, 0.15 center
plot data index "forms" every ::6::9 using (100*column("error")):($0 + 1) \
         with points ls 2 ps 1.6
unset multiplot
