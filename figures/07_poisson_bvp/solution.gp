# solution.gp - u_h on four elements, and its error in between.
#
# Reads   data  tables nodes (x u exact), curve (x uh exact error fitted_error)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 660,500 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3

set multiplot
unset key
set lmargin at screen 0.12
set rmargin at screen 0.97
set xrange [-0.02:1.02]
set xtics ("" 0, "" 0.25, "" 0.5, "" 0.75, "" 1)

set tmargin at screen 0.97
set bmargin at screen 0.58
set yrange [0.79:1.02]
set ytics 0.05
set format y "%.2f"
set ylabel "u (dimensionless)" offset 0.5
set label 1 "exact u" at 0.14, 1.009
set label 2 "u_h: 4 elements, midpoint rule" at 0.48, 0.967 left tc ls 1 boxed
plot data index "curve" using "x":"exact" with lines ls 8 lw 1.6, \
     data index "curve" using "x":"uh" with lines ls 1, \
     data index "nodes" using "x":"u" with points ls 1 ps 0.9

set tmargin at screen 0.54
set bmargin at screen 0.125
set xtics ("0" 0, "1/4" 0.25, "1/2" 0.5, "3/4" 0.75, "1" 1)
set xlabel "x (dimensionless)"
set yrange [-1.3:6.9]
set ytics 2
set format y "%g"
set ylabel "1000 (u − u_h)" offset 0.5
set label 1 "error of a solution that is exact\nat every node" at 0.44, 3.5 tc ls 2 boxed
set label 2 "error of u_h" at 0.625, -0.85 center tc ls 1
# every 32nd row of the curve is a node
plot 0 with lines lc rgb "#000000" lw 0.8, \
     data index "curve" using "x":(1e3 * column("error")) with lines ls 1, \
     data index "curve" every 32 using "x":(1e3 * column("error")) \
         with points ls 1 ps 0.9, \
     data index "curve" using "x":(1e3 * column("fitted_error")) with lines \
         ls 2 dt 4, \
     data index "curve" every 32 using "x":(1e3 * column("fitted_error")) \
         with points ls 2 ps 0.9
unset multiplot
set output
