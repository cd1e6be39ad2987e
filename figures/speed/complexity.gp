# complexity.gp - six ways to solve one system: counted work, and seconds.
# Expected slopes of the work: 6 full, 4 band, 3 dissection and CG without a
# coarser grid, 2 with.
# Reads   data  tables solvers (solver n flops milliseconds), exponents, machine;
#               from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,880
set output out
set datafile missing "-"
array Name[6] = ["dense", "band", "dissection", "jacobi", "incomplete", \
                 "multigrid"]
array Text[6] = ["full", "band", "dissection", "CG, Jacobi", \
                 "CG, incomplete", "CG, V-cycle"]
array Style[6] = [2, 1, 3, 5, 4, 6]
of(k) = strcol("solver") eq Name[k] ? column("n") : NaN
slope(k, what) = real(system(sprintf("awk -F'\t' '$0 == \"# exponents\" \
    { on = 1 } on && $1 == \"%s\" { print $%d }' '%s'", Name[k], what, data)))

set multiplot layout 2,1 margins 0.12,0.73,0.10,0.985 spacing 0,0.09
unset key
set label 9 machine(data) at screen 0.01,0.012 left font ",11"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128, 256)
set xrange [7:300]
set yrange [2e4:2e10]
set xlabel "squares per side n"
set ylabel "flops of a solve, counted"
array Work[6] = [4e9, 6e9, 2.6e9, 1.2e9, 5.4e8, 2.4e8]
do for [k = 1:6] {
    color = Style[k]
    set label 10 + k sprintf("%s  n^{%.2f}", Text[k], slope(k, 3)) \
        at (k == 1 ? 36 : k == 2 ? 130 : 330), Work[k] tc ls color
}
plot for [k = 1:6] data index "solvers" using (of(k)):"flops" with linespoints \
         ls Style[k]
unset label
# where the name of a solver stands
array Height[6] = [300, 36, 80, 900, 420, 190]
do for [k = 1:6] {
    color = Style[k]
    set label k Text[k] at (k == 1 ? 9 : 330), Height[k] tc ls color
}
set ylabel "time of a solve (ms)"
set yrange [2e-3:5e3]
plot for [k = 1:6] data index "solvers" using (of(k)):"milliseconds" \
         with linespoints ls Style[k]
unset multiplot
