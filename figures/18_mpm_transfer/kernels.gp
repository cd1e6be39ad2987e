# kernels.gp - the three kernels; the slope that a node feels of a particle that
# passes it; the quadratic pieces with the wrong first node.
# Reads   data  table kernels
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,980 enhanced font "Helvetica,17" \
    background rgb "white"
set output out
set multiplot
set lmargin at screen 0.14
set rmargin at screen 0.97
set tmargin at screen 0.985
set bmargin at screen 0.71
set xrange [-2.1:2.1]
set xtics 1
set format x ""
unset key
set label 1 "linear" at 0.28, 0.85 tc ls 1
set label 2 "quadratic" at 0.5, 0.62 tc ls 2
set label 3 "cubic" at 1.3, 0.12 tc ls 3
set ylabel "weight N" offset 1
set yrange [-0.3:1.05]
plot data index "kernels" using "t":"N_1" with lines ls 1, \
     "" index "kernels" using "t":"N_2" with lines ls 2, \
     "" index "kernels" using "t":"N_3" with lines ls 3
set tmargin at screen 0.675
set bmargin at screen 0.40
set ylabel "slope h dN/dx" offset 1
set yrange [-1.15:1.2]
set label 2 "quadratic" at -1.08, 0.8 right tc ls 2
set label 3 "cubic" at -1.15, 0.42 right tc ls 3
set label 1 "linear: jumps\nat a node" at -1.9, -0.66 \
    tc ls 1
set arrow 1 from -0.92, -0.75 to -0.06, -0.6 lw 1 lc rgb "#666666"
plot data index "kernels" using "t":"dN_1" with lines ls 1, \
     "" index "kernels" using "t":"dN_2" with lines ls 2, \
     "" index "kernels" using "t":"dN_3" with lines ls 3
unset arrow 1
set tmargin at screen 0.365
set bmargin at screen 0.075
set format x "%g"
set xlabel "place of the particle x/h − i"
set label 1 "a negative weight" at -0.87, -0.1 tc rgb "#A03A78"
set label 2 "first node floor(x/h):\nwrong, it jumps" at 0.25, 1.05 left tc rgb "#A03A78"
set label 3 "first node\nfloor(x/h - 1/2)" at -0.62, 0.66 right tc ls 2
set ylabel "weight, quadratic" offset 1
set yrange [-0.3:1.2]
set ytics 0.2
plot data index "kernels" using "t":"N_2" with lines ls 2, \
     "" index "kernels" using "t":"trap" with lines ls 4 lc rgb "#A03A78" dt 2, \
     0 with lines ls 9
unset multiplot
