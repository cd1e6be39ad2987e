# solution.gp - u_h on four elements, and its error in between.
#
# Reads   data  tables nodes (x u exact), curve (x uh exact error fitted_error)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 720,560 enhanced font "Helvetica,14" \
    background rgb "white"
set output out

set multiplot
set lmargin at screen 0.12
set rmargin at screen 0.97
set xrange [-0.02:1.02]
set xtics ("" 0, "" 0.25, "" 0.5, "" 0.75, "" 1)

set tmargin at screen 0.92
set bmargin at screen 0.57
set yrange [0.79:1.02]
set ytics 0.05
set format y "%.2f"
set ylabel "u (dimensionless)" offset 0.5
set key at screen 0.11, 0.97 left center maxrows 1 reverse Left samplen 2.5
plot data index "curve" using "x":"exact" with lines ls 8 lw 1.6 \
         title "exact u", \
     data index "curve" using "x":"uh" with lines ls 1 notitle, \
     data index "nodes" using "x":"u" with points ls 1 ps 0.9 notitle, \
     NaN with linespoints ls 1 ps 0.9 title "u_h, 4 elements, midpoint rule"

set tmargin at screen 0.465
set bmargin at screen 0.115
set xtics ("0" 0, "1/4" 0.25, "1/2" 0.5, "3/4" 0.75, "1" 1)
set xlabel "x (dimensionless)"
set yrange [-1.3:6.9]
set ytics 2
set format y "%g"
set ylabel "10^3 × (u − u_h)" offset 0.5
set key at screen 0.11, 0.515 left center
# every 16th row of the curve is a node
plot 0 with lines lc rgb "#000000" lw 0.8 notitle, \
     data index "curve" using "x":(1e3 * column("error")) with lines ls 1 \
         notitle, \
     data index "curve" every 16 using "x":(1e3 * column("error")) \
         with points ls 1 ps 0.9 notitle, \
     data index "curve" using "x":(1e3 * column("fitted_error")) with lines \
         ls 2 dt 4 notitle, \
     data index "curve" every 16 using "x":(1e3 * column("fitted_error")) \
         with points ls 2 ps 0.9 notitle, \
     NaN with linespoints ls 1 ps 0.9 title "error, midpoint rule", \
     NaN with linespoints ls 2 dt 4 ps 0.9 \
         title "fitted: 0 at every node"
unset multiplot
set output
