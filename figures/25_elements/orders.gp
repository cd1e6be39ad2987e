# orders.gp - the error of linear and quadratic triangles at the vertices, even
# and graded, at nu = 0.3, against the unknowns, as the n of linear triangles that have as
# many; dashed, in its colour, the order predicted of each.
# Expected: slopes 2 min(k, p m), p of the corner.
# Reads   data  tables error, orders
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,420
set output out
unset key
set label 1 "linear: 1.42" at 138, 1.3e-3 tc ls 2
set label 2 "linear, m = 1.5: 2.00" at 138, 3.6e-4 tc ls 5
set label 3 "quadratic: 1.42" at 14.6, 6.2e-3 right tc ls 1
set label 4 "quadratic, m = 1.5: 2.13" at 14.6, 3.8e-3 right tc ls 6
set label 5 "quadratic, m = 2: 2.84" at 14.6, 2.3e-3 right tc ls 3
set label 6 "dashed, and the number: the predicted order" at 470, 0.25 right
# through a point a little beside the last one of a curve, with its order
by(x, n, error, order) = error * (x / n)**-order
of(name, grading) = strcol("element") eq name && column("m") == grading \
                    && column("nu") == 0.3 ? column("error") : NaN
# as many unknowns as linear triangles of this n
as(name) = column("n") * (name eq "quadratic" ? 2 : 1)
set datafile missing "-"
set logscale xy
set grid noxtics
set xrange [2.4:560]
set yrange [5e-5:0.4]
set xtics (8, 16, 32, 64, 128)
set format y "10^{%T}"
set xlabel "n of linear triangles with as many unknowns"
set ylabel "error at the vertices, relative"
plot data index "error" using (as("linear")):(of("linear", 1)) with linespoints ls 2, \
     "" index "error" using (as("linear")):(of("linear", 1.5)) with linespoints ls 5, \
     "" index "error" using (as("quadratic")):(of("quadratic", 1)) with linespoints ls 1, \
     "" index "error" using (as("quadratic")):(of("quadratic", 1.5)) with linespoints ls 6, \
     "" index "error" using (as("quadratic")):(of("quadratic", 2)) with linespoints ls 3, \
     [16:128] by(x, 128, 1.15e-3, 1.42) with lines ls 2 lw 1.2 dt 2, \
     [32:128] by(x, 128, 3.2e-4, 2.00) with lines ls 5 lw 1.2 dt 2, \
     [16:64] by(x, 64, 6.8e-4, 1.42) with lines ls 1 lw 1.2 dt 2, \
     [16:64] by(x, 64, 1.79e-4, 2.13) with lines ls 6 lw 1.2 dt 2, \
     [16:64] by(x, 64, 6.9e-5, 2.84) with lines ls 3 lw 1.2 dt 2
