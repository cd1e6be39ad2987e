# band.gp - factor and solve the band of n x n squares: seconds, and flops per
# second.  Expected: slope 4; 6 where the matrix is full.
# Reads   data  tables band (solver n milliseconds gigaflop_per_second), peak
#               (n gigaflop_per_second), machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,860
set output out
array Solver[4] = ["gsl_dense", "gsl_banded", "lapack_dpbtrf", "ours"]
array Name[4] = ["GSL, full matrix", "GSL, band", "dpbtrf of ".lapack(data), \
                 "common/linear/tiles.c"]
array Style[4] = [2, 5, 4, 1]
has(t) = system(sprintf("grep -c '^%s\t' '%s'", t, data)) > 0
there = ""
do for [k = 1:4] { if (has(Solver[k])) { there = there." ".k } }
of(k) = strcol("solver") eq Solver[int(k)] ? column("n") : NaN

set multiplot layout 2,1 margins 0.12,0.70,0.09,0.985 spacing 0,0.09
unset key
set label 2 "slope 4" at 75, 1.2
if (has("gsl_dense")) { set label 3 Name[1] at 35, 2.1e3 tc ls Style[1] }
set label 9 machine(data) at screen 0.01,0.012 left textcolor rgb "#555555"
set logscale xy
set xtics (16, 32, 64, 128)
set xrange [14:150]
set format y "10^{%T}"
set yrange [2e-2:5e3]
set xlabel "squares per side n"
set ylabel "time to factor and solve (ms)"
# the last point of each but the full matrix
do for [k in there] {
    i = int(k)
    if (i > 1) {
        stats data index "band" using (strcol("solver") eq Solver[i] && \
            column("n") == 128 ? column("milliseconds") : NaN) \
            nooutput name "last"
        color = Style[i]
        # that of LAPACK above ours, which it may hide
        set label 10 + i Name[i] at 158, last_max tc ls color offset 0, i == 3 ? 1 : 0
    }
}
plot for [k in there] data index "band" using (of(k)):"milliseconds" \
         with linespoints ls Style[int(k)], \
     8e-8 * x**4 with lines ls 8
unset label
do for [k in there] {
    i = int(k)
    if (i > 1) {
        stats data index "band" using (strcol("solver") eq Solver[i] && \
            column("n") == 128 ? column("gigaflop_per_second") : NaN) \
            nooutput name "last"
        color = Style[i]
        set label i Name[i] at 158, last_max tc ls color offset 0, i == 3 ? 1 : 0
    }
}
stats data index "peak" using "gigaflop_per_second" nooutput name "peak"
set label 5 "limit of the core" at 158, peak_max
unset logscale y
set format y "%g"
set yrange [0:*]
set ylabel "flops per second (10^{9}/s)"
plot for [k in there] data index "band" \
         using (of(k)):"gigaflop_per_second" \
         with linespoints ls Style[int(k)], \
     data index "peak" using "n":"gigaflop_per_second" with lines ls 8 dt 4
unset multiplot
