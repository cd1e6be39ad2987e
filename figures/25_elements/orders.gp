# orders.gp - the error of linear and quadratic triangles at the shared vertices,
# even and graded, at nu = 0.3, against the unknowns; dashed, in its colour, the
# order predicted of each.
# Expected: slopes min(k, p m), p of the corner, since unknowns are like 1/h^2.
# Reads   data  tables error, orders
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,420
set output out
unset key
set label 1 "linear: 1.42" at 40000, 1.3e-3 tc ls 2
set label 2 "linear, m = 1.5: 2.00" at 40000, 3.6e-4 tc ls 5
set label 3 "quadratic: 1.42" at 440, 6.2e-3 right tc ls 1
set label 4 "quadratic, m = 1.5: 2.13" at 440, 3.8e-3 right tc ls 6
set label 5 "quadratic, m = 2: 2.84" at 440, 2.3e-3 right tc ls 3
set label 6 "dashed: predicted; the number: its order in h (unknowns \\~ h^{-2})" at 450000, 0.25 right
# through a point a little beside the last one of a curve, with its order in h
by(x, last, error, order) = error * (x / last)**(-0.5 * order)
of(name, grading) = strcol("element") eq name && column("m") == grading \
                    && column("nu") == 0.3 ? column("error") : NaN
# both components of the vertices that are not held
free(cells) = 2 * cells * (cells + 1)
unknowns(name) = free(column("n") * (name eq "quadratic" ? 2 : 1))
set datafile missing "-"
set logscale xy
set grid noxtics
set xrange [12:6e5]
set yrange [5e-5:0.4]
set format "10^{%T}"
set xlabel "unknowns"
set ylabel "error at the shared vertices, relative"
plot data index "error" using (unknowns("linear")):(of("linear", 1)) with linespoints ls 2, \
     "" index "error" using (unknowns("linear")):(of("linear", 1.5)) with linespoints ls 5, \
     "" index "error" using (unknowns("quadratic")):(of("quadratic", 1)) with linespoints ls 1, \
     "" index "error" using (unknowns("quadratic")):(of("quadratic", 1.5)) with linespoints ls 6, \
     "" index "error" using (unknowns("quadratic")):(of("quadratic", 2)) with linespoints ls 3, \
     [free(16):free(128)] by(x, free(128), 1.15e-3, 1.42) with lines ls 2 lw 1.2 dt 2, \
     [free(32):free(128)] by(x, free(128), 3.2e-4, 2.00) with lines ls 5 lw 1.2 dt 2, \
     [free(16):free(64)] by(x, free(64), 6.8e-4, 1.42) with lines ls 1 lw 1.2 dt 2, \
     [free(16):free(64)] by(x, free(64), 1.79e-4, 2.13) with lines ls 6 lw 1.2 dt 2, \
     [free(16):free(64)] by(x, free(64), 6.9e-5, 2.84) with lines ls 3 lw 1.2 dt 2
