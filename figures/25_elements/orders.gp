# orders.gp - the error of linear and quadratic triangles at the shared vertices,
# even and graded, at nu = 0.3, against the unknowns; dashed, in its colour and
# from the first point of each, the order predicted.
# Expected: slopes min(k, p m), p of the corner, since unknowns are like 1/h^2.
# Reads   data  tables error, orders
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,440
set output out
array Name[5] = ["linear", "linear", "quadratic", "quadratic", "quadratic"]
array M[5] = [1, 1.5, 1, 1.5, 2]
array Style[5] = [2, 5, 1, 6, 3]
array X[5] = [40000, 40000, 440, 440, 440] # where their labels stand
array Y[5] = [1.3e-3, 3.6e-4, 6.2e-3, 3.8e-3, 2.3e-3]
array Order[5] # predicted
is(k) = strcol("element") eq Name[k] && column("m") == M[k] \
        && column("nu") == 0.3
text(k) = (M[k] > 1 ? sprintf("%s, m = %g", Name[k], M[k]) : Name[k]) \
          . sprintf(": %.2f, seen %.2f", column("predicted"), column("observed"))
# from the first mesh, n = 8, on
from(k) = column("n") == 8 ? (first = column("error")) \
                           : first * (column("n") / 8.0)**(-Order[k])
# both components of the vertices that are not held
free(cells) = 2 * cells * (cells + 1)
unknowns(name) = free(column("n") * (name eq "quadratic" ? 2 : 1))
set datafile missing "-"
set table $ignored # only to read Order
do for [k = 1:5] {
    plot [0:5] [-1:1] data index "orders" using (is(k) ? (Order[k] = column("predicted")) : NaN):(0)
}
unset table
unset key
set label 1 "dashed: predicted order in h (unknowns \\~ h^{-2})" at 4e6, 0.26 right
set label 2 "seen: between the last two points" at 4e6, 0.16 right
set logscale xy
set grid noxtics
set xrange [2:5e6]
set yrange [5e-5:0.4]
set format "10^{%T}"
set xlabel "unknowns"
set ylabel "error at the shared vertices, relative"
plot for [k = 1:5] data index "error" using (unknowns(Name[k])):(is(k) ? from(k) : NaN) \
         with lines ls Style[k] lw 1.2 dt 2, \
     for [k = 1:5] "" index "error" using (unknowns(Name[k])):(is(k) ? column("error") : NaN) \
         with linespoints ls Style[k], \
     for [k = 1:2] "" index "orders" using (X[k]):(is(k) ? Y[k] : NaN):(text(k)) \
         with labels left tc ls Style[k], \
     for [k = 3:5] "" index "orders" using (X[k]):(is(k) ? Y[k] : NaN):(text(k)) \
         with labels right tc ls Style[k]
