# unheld.gp - a motion of the nodes that stretches no particle.
# Reads   data  tables field, particles
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,340 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set xrange [0:8]
set yrange [-0.05:1.05]
set xtics 1
set xlabel "x (cells)"
set ylabel "displacement"
unset key
set label 1 "displacement between the nodes" at 2.35, 0.78 tc ls 1
set label 2 "particles: the slope is 0 at each of them" at 1.2, 0.27 tc ls 2
plot data index "field" using "x":"u" with lines ls 1, \
     data index "particles" using "x":"u" with points ls 2 pt 7 ps 1
