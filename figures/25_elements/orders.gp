# orders.gp - the error of linear and quadratic triangles at the vertices, even
# and graded, against n, with the predicted orders.
# Expected: slopes 2 min(k, p m), p of the corner.
# Reads   data  tables error, orders
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,400
set output out
unset key
set label 1 "linear" at 10, 0.055 tc ls 2
set label 2 "linear, m = 1.5" at 125, 2.6e-4 right tc ls 5
set label 3 "quadratic" at 34, 7.5e-4 tc ls 1
set label 4 "quadratic, m = 1.5" at 34, 1.7e-4 tc ls 6
set label 5 "quadratic, m = 2" at 34, 7.5e-5 tc ls 3
set label 6 "dashed: orders 1.42, 2.13, 2.84" at 150, 0.25 right
of(name, grading) = strcol("element") eq name && column("m") == grading \
                    ? column("error") : NaN
set datafile missing "-"
set logscale xy
set xrange [6.5:160]
set yrange [5e-5:0.4]
set xtics (8, 16, 32, 64, 128)
set format y "10^{%T}"
set xlabel "squares per side n"
set ylabel "error at the vertices, relative"
plot data index "error" using "n":(of("linear", 1)) with linespoints ls 2, \
     "" index "error" using "n":(of("linear", 1.5)) with linespoints ls 5, \
     "" index "error" using "n":(of("quadratic", 1)) with linespoints ls 1, \
     "" index "error" using "n":(of("quadratic", 1.5)) with linespoints ls 6, \
     "" index "error" using "n":(of("quadratic", 2)) with linespoints ls 3, \
     [16:128] 1.35 * x**-1.42 with lines ls 8, \
     [8:32] 0.075 * x**-1.42 with lines ls 8, \
     [8:32] 0.25 * x**-2.13 with lines ls 8, \
     [8:32] 0.95 * x**-2.84 with lines ls 8
