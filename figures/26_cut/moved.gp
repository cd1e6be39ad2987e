# moved.gp - the error of the opening of a cut against flops, over 24 slanting blades,
# and its standard deviation: along edges, and with moved vertices.
# Reads   data  table opening
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,360 enhanced font "Helvetica,15" background rgb "white"
set output out
set logscale xy
set xrange [4e4:1.2e7]
set format x "10^{%T}"
set yrange [0.04:0.6]
set ytics (0.05, 0.1, 0.2, 0.4)
set xlabel "flops to factor K and to solve"
set ylabel "missing part of the opening"
set label 1 "root mean square" at 4e5,0.26
set label 2 "standard deviation" at 3e5,0.068 right
plot data index "opening" using "flops":"edges_rms" with linespoints ls 1 \
         title "along edges", \
     "" index "opening" using "flops":"moved_rms" with linespoints ls 2 \
         title "with moved vertices", \
     "" index "opening" using "flops":"edges_spread" with linespoints ls 1 dt 3 notitle, \
     "" index "opening" using "flops":"moved_spread" with linespoints ls 2 dt 3 notitle, \
     "" index "opening" using "flops":(0.5):(sprintf("n = %d", column("n"))) \
         with labels notitle
