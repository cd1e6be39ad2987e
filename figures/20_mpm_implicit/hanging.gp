# hanging.gp - errors of the hanging bar against work: on one grid, as finite
# elements, and with a new grid for each of ten loads.
# Reads   data  tables elements, once (kernels by a mirror, then held), reset
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 820,430
set output out
set multiplot
set tmargin at screen 0.92
set bmargin at screen 0.13
unset key
set logscale xy
set xrange [13:1400]
set yrange [3e-6:0.5]
set format y "10^{%T}"
set xlabel "particles × nodes per particle"
set ylabel "error of the worst place (m)"
set lmargin at screen 0.085
set rmargin at screen 0.45
set title "one grid: all the load in one step"
set label 1 "finite\nelements" at 15, 1.6e-4
set label 2 "nodes held: order 1" at 120, 6e-2 tc rgb "#777777"
set label 4 "quadratic" at 350, 2.2e-3 right tc rgb "#777777"
set label 5 "cubic" at 600, 5e-3 tc rgb "#777777"
set label 6 "mirror: order 2" at 130, 2.6e-4
set label 7 "linear" at 36, 1.3e-3 tc ls 1
set label 8 "quadratic" at 57, 8.4e-4 tc ls 2
set label 9 "cubic" at 77, 5e-4 tc ls 3
plot data index "elements" using "work":"error" with linespoints ls 8 pt 6, \
     for [p = 1:3] data index "once" every ::4*(p-1)::4*p-1 \
         using "work":"error" with linespoints ls p, \
     for [p = 2:3] data index "once" every ::12+4*(p-2)::12+4*(p-2)+3 \
         using "work":"error" with linespoints ls p dt 3 lc rgb "#999999"
unset label
unset ylabel
set format y ""
set lmargin at screen 0.49
set rmargin at screen 0.855
set title "a new grid for each of ten loads"
set label 1 "linear, 4 per cell" at 1500, 3.5e-2 tc ls 1
set label 2 "quadratic, 2" at 1500, 8.1e-3 tc ls 2
set label 3 "cubic, 2" at 1500, 9e-4 tc ls 3
set label 4 "quadratic, 4" at 1500, 2.6e-4 tc ls 2
set label 5 "cubic, 4" at 1500, 1.1e-5 tc ls 3
set label 6 "linear, 2: NOT\\_SPD on finer grids" at 38, 0.25 tc ls 1
set label 7 "finite\nelements" at 15, 1.6e-4
plot data index "elements" using "work":"error" with linespoints ls 8 pt 6, \
     for [p = 1:3] data index "reset" every ::4*(p-1)::4*p-1 \
         using "work":"error" with linespoints ls p dt 3, \
     for [p = 1:3] data index "reset" every ::4*(p+2)::4*(p+2)+3 \
         using "work":"error" with linespoints ls p
unset multiplot
