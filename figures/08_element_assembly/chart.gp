# chart.gp - the speed-accuracy chart: what an error costs.
#
# Expected: error ~ n^-2 and cost ~ n (banded) or n^3 (dense), hence slopes -2
# and -2/3.  A run that is not valid has no time: a cross at the top.
# Reads   data  tables chart_dense, chart_banded (n flops seconds L2 valid
#               roundoff), machine from the note
# Writes  out   SVG

load "figures/style.gp"
set terminal svg size 740,430 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3

is(c, word) = strcol(c) eq word
# Measured slopes, in the seconds: least squares over the valid points before
# round-off (L2 > 1e-9), without the small n whose time is mostly the call.
good(c) = is("valid", "yes") && is("roundoff", "no") && \
          column("n") >= 64 && column("L2") > 1e-9 ? log(column(c)) : 1/0
do for [c in "seconds flops"] {
    stats data index "chart_dense" using (good(c)):(good("L2")) \
        name "D".c nooutput
    stats data index "chart_banded" using (good(c)):(good("L2")) \
        name "B".c nooutput
}
ok(c) = is("valid", "yes") && is("roundoff", "no") ? column(c) : 1/0
turned(c) = is("valid", "yes") && is("roundoff", "yes") ? column(c) : 1/0
any(c) = is("valid", "yes") ? column(c) : 1/0
failed(y) = is("valid", "no") ? y : 1/0
line(x, m, lx, ly, factor) = factor*exp(ly + m*(log(x) - lx))

set multiplot layout 1,2 margins 0.13,0.965,0.235,0.97 spacing 0.12,0
set logscale xy
set format xy "10^{%T}"
top = 1e-3
set yrange [1e-11:2*top]
set ytics 1e-11, 100
unset mytics; unset mxtics
set ylabel "L² error (dimensionless)"
unset key
set label 9 machine(data) at screen 0.01,0.035 left

set xrange [1e-7:1]
set xtics 1e-7, 100
set xlabel "time of factor + solve (s)"
set label 1 sprintf("dense: slope %.2f", Dseconds_slope) at 4e-6, 2.2e-4 tc ls 2 boxed
set label 2 sprintf("banded:\nslope %.2f", Bseconds_slope) at 1.8e-5, 2.5e-7 tc ls 1 boxed
set label 3 "rings:\nround-off" at 3e-4, 4e-9 tc ls 1 boxed
set label 4 "1/30 s" at 0.05, 8e-4 boxed
set label 5 "dashed:\n-2/3, -2" at 1.6e-7, 1.5e-10 boxed
set arrow 1 from 1/30., 1e-11 to 1/30., 2*top nohead lw 2 lc rgb "#999999"
plot data index "chart_dense" using (ok("seconds")):"L2" with linespoints ls 2, \
     "" index "chart_banded" using (ok("seconds")):"L2" with linespoints ls 1, \
     "" index "chart_banded" using (any("seconds")):"L2" with lines ls 1 lw 1, \
     "" index "chart_banded" using (turned("seconds")):"L2" with points \
         ls 1 pt 6, \
     line(x, -2.0/3, Dseconds_mean_x, Dseconds_mean_y, 1.6) with lines ls 8, \
     line(x, -2.0, Bseconds_mean_x, Bseconds_mean_y, 0.5) with lines ls 8, \
     "" index "chart_dense" using (2e-7):(failed(top)) with points pt 2 ps 1 \
         lc rgb "#D55E00", \
     "" index "chart_banded" using (4e-7):(failed(top)) with points pt 2 ps 1 \
         lc rgb "#0072B2"

unset label
unset arrow
set xrange [1e1:1e9]
set xtics 1e1, 100
set xlabel "work of factor + solve (flops)"
unset ylabel
set label 1 sprintf("dense: slope %.2f", Dflops_slope) at 3e4, 2.2e-4 tc ls 2 boxed
set label 2 sprintf("banded:\nslope %.2f", Bflops_slope) at 2e4, 2.5e-7 tc ls 1 boxed
set label 3 "rings:\nround-off" at 2.5e5, 4e-9 tc ls 1 boxed
plot data index "chart_dense" using (ok("flops")):"L2" with linespoints ls 2, \
     "" index "chart_banded" using (ok("flops")):"L2" with linespoints ls 1, \
     "" index "chart_banded" using (any("flops")):"L2" with lines ls 1 lw 1, \
     "" index "chart_banded" using (turned("flops")):"L2" with points \
         ls 1 pt 6, \
     line(x, -2.0/3, Dflops_mean_x, Dflops_mean_y, 1.6) with lines ls 8, \
     line(x, -2.0, Bflops_mean_x, Bflops_mean_y, 0.5) with lines ls 8, \
     "" index "chart_dense" using "flops":(failed(top)) with points pt 2 ps 1 \
         lc rgb "#D55E00", \
     "" index "chart_banded" using "flops":(failed(top)) with points pt 2 ps 1 \
         lc rgb "#0072B2"
unset multiplot
set output
