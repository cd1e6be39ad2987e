# iterations.gp - CG with three preconditioners: the residual after each
# iteration, and how many iterations n takes.
# Expected: slope 1 without a coarser grid, 0 with.
# Reads   data  tables history, iterations
# Writes  out   SVG
load "figures/style.gp"
set datafile missing "-"
set terminal svg size 580,760
set output out
array Name[3] = ["jacobi", "incomplete", "multigrid"]
array Style[3] = [5, 4, 6]
of(k, what) = strcol("with") eq Name[k] ? column(what) : NaN

set multiplot layout 2,1 margins 0.12,0.975,0.075,0.985 spacing 0,0.1
set logscale y
set grid noxtics
unset key
set label 3 "V-cycle" at 12, 1e-9 tc ls 6
set label 4 "incomplete\nCholesky" at 55, 4e-7 tc ls 4
stats data index "iterations" using "jacobi" every ::1::1 nooutput name "all"
set label 5 sprintf("Jacobi, %.0f in all", all_max) at 60, 0.05 tc ls 5
set format y "10^{%T}"
set yrange [1e-11:30]
set xrange [0:105]
set xlabel "iterations, n = 32"
set ylabel "|r| / |b|" offset 1
plot for [k = 1:3] data index "history" using (of(k, "k")):"residual" \
         with lines ls Style[k] lw 2.5
set logscale x
set format y "%g"
set xrange [14:300]
set xtics (16, 32, 64, 128, 256)
set yrange [2:900]
set ytics (2, 5, 10, 20, 50, 100, 200, 500)
set xlabel "squares per side n"
set ylabel "iterations" offset 0.5
set label 3 "V-cycle" at 64, 13 tc ls 6
set label 4 "incomplete Cholesky" at 72, 134 tc ls 4
set label 5 "Jacobi" at 72, 380 tc ls 5
set label 1 "dashed: to 10^{-4}, full: to 10^{-10}" at graph 0.03,0.955
set label 2 "slope 1" at 175,40
plot for [k = 1:3] data index "iterations" using "n":Name[k] \
         with linespoints ls Style[k], \
     for [k = 1:3] "" index "iterations" using "n":Name[k]."_rough" \
         with linespoints ls Style[k] dt 2, \
     [128:250] 0.35 * x with lines ls 8
unset multiplot
