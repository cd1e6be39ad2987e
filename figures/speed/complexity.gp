# complexity.gp - six ways to solve one system: counted work, and seconds.
# Expected slopes of the work: 6 full, 4 band, 3 dissection and CG without a
# coarser grid, 2 with.
# Reads   data  tables solvers (solver n flops milliseconds), exponents, machine;
#               from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 1000,420
set output out
set datafile missing "-"
array Name[6] = ["dense", "band", "dissection", "jacobi", "incomplete", \
                 "multigrid"]
array Text[6] = ["full Cholesky", "band", "nested dissection", \
                 "CG, Jacobi", "CG, incomplete Cholesky", "CG, V-cycle"]
array Style[6] = [2, 1, 3, 5, 4, 6]
of(k) = strcol("solver") eq Name[k] ? column("n") : NaN
slope(k, what) = real(system(sprintf("awk -F'\t' '$0 == \"# exponents\" \
    { on = 1 } on && $1 == \"%s\" { print $%d }' '%s'", Name[k], what, data)))

set multiplot layout 1,2 margins 0.07,0.77,0.165,0.965 spacing 0.09,0
unset key
set label 9 machine(data) at screen 0.01,0.025 left font ",10"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128, 256)
set xrange [7:300]
set yrange [2e4:2e10]
set xlabel "squares per side n"
set ylabel "flops of a solve, counted"
plot for [k = 1:6] data index "solvers" using (of(k)):"flops" with linespoints \
         ls Style[k]
unset label 9
# where the name of a solver stands, with the slope of its work
array Height[6] = [300, 36, 80, 900, 420, 190]
do for [k = 1:6] {
    color = Style[k]
    set label k sprintf("%s (%.2f)", Text[k], slope(k, 3)) \
        at (k == 1 ? 9 : 320), Height[k] tc ls color
}
set label 7 "(slope of the flops)" at 320, 3e3
set ylabel "time of a solve (ms)"
set yrange [2e-3:5e3]
plot for [k = 1:6] data index "solvers" using (of(k)):"milliseconds" \
         with linespoints ls Style[k]
unset multiplot
