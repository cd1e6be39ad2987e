# complexity.gp - six ways to solve one system: counted work, and seconds.
# Expected slopes of the work: 6 full, 4 band, 3 dissection and CG without a
# coarser grid, 2 with.
# Reads   data  tables solvers (solver n flops milliseconds), exponents, machine;
#               from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,880
set output out
set datafile missing "-"
array Name[6] = ["dense", "band", "dissection", "jacobi", "incomplete", \
                 "multigrid"]
array Text[6] = ["full Cholesky", "band", "dissection", \
                 "CG, Jacobi", "CG, incomplete", "CG, V-cycle"]
array Style[6] = [2, 1, 3, 5, 4, 6]
of(k) = strcol("solver") eq Name[k] ? column("n") : NaN
slope(k, what) = real(system(sprintf("awk -F'\t' '$0 == \"# exponents\" \
    { on = 1 } on && $1 == \"%s\" { print $%d }' '%s'", Name[k], what, data)))

# The name of a solver stands at the height where its curve ends, or a little
# above or below; a thin line leads to it where another curve lies between.
set multiplot layout 2,1 margins 0.115,0.735,0.10,0.985 spacing 0,0.09
unset key
set label 9 machine(data) at screen 0.01,0.012 left textcolor rgb "#555555"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128, 256)
set xrange [7:300]
set yrange [2e4:2e10]
set xlabel "squares per side n"
set ylabel "flops, factors included"
array X[6] = [31, 128, 320, 320, 320, 320]
array Work[6] = [5.5e9, 4.4e9, 2.55e9, 1.26e9, 6.3e8, 3e8]
do for [k = 1:6] {
    color = Style[k]
    set label 10 + k sprintf("%s, n^{%.2f}", Text[k], slope(k, 3)) \
        at X[k], Work[k] tc ls color left
}
do for [k = 4:5] {
    color = Style[k]
    set arrow k from 136, Work[k] to 305, Work[k] nohead ls color lw 0.8
}
set label 11 right
set label 12 right
plot for [k = 1:6] data index "solvers" using (of(k)):"flops" with linespoints \
         ls Style[k]
do for [k = 9:16] { unset label k }
unset arrow
array Time[6] = [170, 47, 85, 1250, 950, 430]
array From[6] = [31, 138, 320, 142, 320, 320]
do for [k = 1:6] {
    color = Style[k]
    set label 10 + k Text[k] at From[k], Time[k] tc ls color
}
color = Style[5]
set arrow 5 from 136, 440 to 305, 900 nohead ls color lw 0.8
set label 11 right
set ylabel "time to factor and solve (ms)"
set yrange [2e-3:5e3]
plot for [k = 1:6] data index "solvers" using (of(k)):"milliseconds" \
         with linespoints ls Style[k]
unset multiplot
