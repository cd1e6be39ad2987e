# hanging.gp - errors of the hanging bar against work: on one grid (above) and
# with a new grid for each of ten loads (below), and as finite elements.
# Reads   data  tables elements, once (kernels by a mirror, then held), reset
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,980 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
set multiplot
set lmargin at screen 0.165
set rmargin at screen 0.97
set tmargin at screen 0.955
set bmargin at screen 0.55
unset key
set logscale xy
set xrange [13:1400]
set xtics (16, 32, 64, 128, 256, 512, 1024)
set yrange [3e-6:0.1]
set format y "10^{%T}"
set format x ""
set ylabel "largest error of position (m)"
set label 10 "one grid, two particles per cell" at graph 0, graph 1.045
set label 1 "finite\nelements" at 14.5, 1.4e-4
set label 2 "quadratic, nodes\nheld: order 1" at 190, 5e-2 tc ls 2
set label 6 "mirror: order 2" at 190, 1.8e-4
set label 7 "linear" at 36, 1.6e-3 tc ls 1
set label 8 "quadratic" at 57, 9e-4 tc ls 2
set label 9 "cubic" at 80, 5e-4 tc ls 3
plot data index "elements" using "work":"error" with linespoints ls 8 pt 6, \
     for [p = 1:3] data index "once" every ::4*(p-1)::4*p-1 \
         using "work":"error" with linespoints ls p, \
     data index "once" every ::12::15 using "work":"error" \
         with linespoints ls 2 dt 3
unset label 2
unset label 6
set tmargin at screen 0.49
set bmargin at screen 0.085
set xtics ("16" 16, "32" 32, "64" 64, "128" 128, "256" 256, "512" 512, \
    "1024" 1024)
set xlabel "work per load: particles (elements) times the nodes of each"
set label 10 "a new grid for each of ten loads, four per cell"
set label 7 "linear kernel" at 110, 2e-2
set label 8 "quadratic" at 300, 7e-4
set label 9 "cubic" at 560, 5e-5
plot data index "elements" using "work":"error" with linespoints ls 8 pt 6, \
     for [p = 1:3] data index "reset" every ::4*(p+2)::4*(p+2)+3 \
         using "work":"error" with linespoints ls p
unset multiplot
