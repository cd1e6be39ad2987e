# block.gp - a block of particles that falls and turns.
# Reads   data  table outline
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,400 enhanced font "Helvetica,17" \
    background rgb "white"
set output out
set size ratio -1
set xrange [0.05:2.75]
set yrange [-0.48:0.72]
unset xtics
set xlabel "x: each picture stands 0.62 m further to the right"
set ylabel "y (m)"
unset key
set label 5 "FLIP" at 2.58, -0.33 tc ls 2
set label 6 "PIC" at 2.15, -0.4 right tc ls 1 offset -1, 0
set label 1 "start" at 0.38, 0.64 center
set label 2 "0.1 s" at 1.04, 0.64 center
set label 3 "0.2 s" at 1.70, 0.64 center
set label 4 "0.3 s" at 2.36, 0.64 center
# the scale along x
set arrow 1 from 0.25, -0.3 to 0.45, -0.3 heads size 0.02, 90 lw 2
set label 7 "0.2 m" at 0.35, -0.23 center
plot for [k = 0:3] data index "outline" every ::13*k+52::13*k+64 \
         using (column("x") + 0.62 * k):"y" with linespoints ls 2, \
     for [k = 0:3] data index "outline" every ::13*k::13*k+12 \
         using (column("x") + 0.62 * k):"y" with linespoints ls 1
