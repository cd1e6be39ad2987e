# hanging.gp - errors of the hanging bar against work: on one grid, as finite
# elements, and with a new grid for each of ten loads.
# Reads   data  tables elements, once (kernels by a mirror, then held), reset
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,480
set output out
set multiplot layout 1,2 margins 0.085,0.985,0.12,0.83 spacing 0.07,0
set logscale xy
set xrange [13:1400]
set yrange [3e-6:0.5]
set format y "10^{%T}"
set xlabel "particles × nodes per particle"
set ylabel "worst place (m)"
set key at screen 0.085,0.985 left top horizontal maxrows 1 samplen 2 width 2
set label 1 "one grid: all the load in one step" at graph 0.03, graph 1.04
set label 2 "nodes at x ≤ 0 held: order 1" at 48, 7e-2
set label 3 "a mirror at 0: order 2" at 130, 3e-4
plot data index "elements" using "work":"error" with linespoints ls 8 pt 6 \
         title "finite elements", \
     for [p = 1:3] data index "once" every ::4*(p-1)::4*p-1 \
         using "work":"error" with linespoints ls p \
         title word("linear quadratic cubic", p), \
     for [p = 2:3] data index "once" every ::12+4*(p-2)::12+4*(p-2)+3 \
         using "work":"error" with linespoints ls p dt 3 notitle
unset ylabel
set label 1 "a new grid for each of ten loads"
set label 2 "two per cell" at 440, 7.6e-3
set label 3 "four per cell" at 560, 3.6e-2
set label 4 "two per cell: NOT\\_SPD from 16 cells on" at 38, 0.25
set label 5 "two per cell" at 570, 6.5e-4
set label 6 "four per cell" at 520, 1.3e-4
set label 7 "four per cell" at 280, 1.3e-5
plot data index "elements" using "work":"error" with linespoints ls 8 pt 6 \
         notitle, \
     for [p = 1:3] data index "reset" every ::4*(p-1)::4*p-1 \
         using "work":"error" with linespoints ls p dt 3 \
         notitle, \
     for [p = 1:3] data index "reset" every ::4*(p+2)::4*(p+2)+3 \
         using "work":"error" with linespoints ls p \
         notitle
unset multiplot
