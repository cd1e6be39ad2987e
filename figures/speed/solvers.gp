# solvers.gp - a factorisation, a solve and a whole step by the band, by nested
# dissection, and by CHOLMOD where there is one.
# Expected: slopes 4 and 3 of the factorisation for large n, 3 and 2 of the solve.
# Reads   data  tables solvers (solver n factor_ms solve_ms step_ms), crossover,
#               machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 960,420
set output out
array Name[4] = ["band", "dissection", "single", "cholmod"]
array Text[4] = ["blocked band", "nested dissection by fronts", \
                 "dissection in single precision", \
                 "CHOLMOD, same order"]
array Style[4] = [1, 3, 2, 4]
of(k) = strcol("solver") eq Name[int(k)] ? column("n") : NaN
has(k) = system(sprintf("grep -c '^%s\t' '%s'", Name[k], data)) > 0
there = ""
do for [k = 1:4] { if (has(k)) { there = there." ".k } }
stats data index "crossover" using "step_n" nooutput name "C"
set datafile missing "-"

set multiplot layout 1,2 margins 0.07,0.775,0.165,0.965 spacing 0.09,0
unset key
set label 9 machine(data) at screen 0.01,0.025 left font ",10"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128, 256)
set xrange [7:300]
set yrange [1e-3:2e3]
set xlabel "squares per side n"
set ylabel "factorisation; dashed: solve (ms)"
plot for [k in there] data index "solvers" using (of(k)):"factor_ms" \
         with linespoints ls Style[int(k)], \
     for [k in there] data index "solvers" using (of(k)):"solve_ms" \
         with linespoints ls Style[int(k)] dt 2 lw 1.2
unset label 9
array Height[4] = [800, 125, 70, 230]
do for [k in there] {
    i = int(k)
    color = Style[i]
    set label 10 + i Text[i] at 320, Height[i] tc ls color
}
set ylabel "whole time step (ms)"
set yrange [1e-2:2e3]
set label 2 "1/30 s" at 7.4,46 left font ",11"
set label 3 sprintf("from n = %d on dissection is faster", C_max) \
    at graph 0.40,0.07 left font ",11"
plot for [k in there] data index "solvers" using (of(k)):"step_ms" \
         with linespoints ls Style[int(k)], \
     1000.0 / 30.0 with lines ls 8
unset multiplot
