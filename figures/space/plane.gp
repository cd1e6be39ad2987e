# plane.gp - how much more or less than a block of finite depth the two planes
# sag, against depth over height.
# Reads   data  table plane
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,400 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
set logscale x 2
set xrange [0.14:5]
set yrange [-6:7]
set xtics ("1/6" 1./6, "1/2" 0.5, "1" 1, "2" 2, "4" 4)
set xlabel "depth of the block over its height"
set ylabel "sag of the plane, less that of the block (%)"
set xzeroaxis ls 8
unset key
set label 1 "plane stress" at 0.2, 2.6 tc ls 2
set label 2 "plane strain" at 0.2, -5.3 tc ls 1
set label 3 "the block" at 0.2, 0.4
plot data index "plane" using "depth":"stress" \
         with linespoints ls 2, \
     data index "plane" using "depth":"strain" \
         with linespoints ls 1
