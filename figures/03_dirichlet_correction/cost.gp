# cost.gp - conjugate gradients with the old diagonal entry and with 1: the error after
# each iteration, and the bound on it; and the error that the residual accepts, against
# a factor that beta and f have in common.
# Reads   data  tables counts, path, units
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 760,430 enhanced font "Helvetica,16"
set output out
of(start, y) = strcol("start") eq start ? column(y) : 1/0
set multiplot layout 1,2 margins 0.13,0.975,0.175,0.91 spacing 0.15,0
unset key

array Start[2] = ["kept", "one"]
array Root[2]
array Count[2]
do for [k = 1:2] {
    stats data index "counts" using (of(Start[k], "condition")) \
        every ::(k - 1)::(k - 1) nooutput
    Root[k] = sqrt(STATS_min)
    stats data index "counts" using (of(Start[k], "iterations")) \
        every ::(k - 1)::(k - 1) nooutput
    Count[k] = STATS_min
    # below 1e-6 the error is soon round-off: a line to the count for ten digits
    stats data index "path" using (of(Start[k], "iteration")):(of(Start[k], "error")) \
        nooutput
    set arrow k from STATS_pos_min_y, STATS_min_y to Count[k], 1e-10 nohead ls k
}
bound(k, n) = 2 * ((Root[k] - 1) / (Root[k] + 1))**n
set title "error and its bound, 64 elements" offset 0,-0.5
set logscale xy
set samples 2000
set xrange [1:2e4]
set yrange [1e-10:5]
set format xy "10^{%T}"
set xlabel "iterations"
set ylabel "error, relative to the first" offset 0.5
set label 1 "measured:" at 50, 1e-6 right boxed
set label 2 sprintf("old entry: %d", Count[1]) at 50, 1e-7 right textcolor ls 1 boxed
set label 3 sprintf("1 on the\ndiagonal: %d", Count[2]) at 50, 1e-8 right textcolor ls 2 boxed
set label 4 "bounds" at 2.2e3, 0.8 left boxed
plot for [k = 1:2] bound(k, x) with lines ls k dt 2, \
     for [k = 1:2] data index "path" \
         using "iteration":(of(Start[k], "error")) with lines ls k

set title "what a small residual accepts" offset 0,-0.5
unset arrow 1
unset arrow 2
unset label 1
unset label 4
unset logscale y
set yrange [-0.13:1.05]
set format y "%g"
set label 2 "1 on\nthe diagonal" at 90, 0.9 left textcolor ls 2 boxed
set label 3 "the old entry" at 2e6, -0.075 right textcolor ls 1 boxed
set label 5 "1, started\nat u_0 = g" at 1.2e2, 0.21 left textcolor ls 2 boxed
set xrange [5e-5:2e6]
set xlabel "factor of β and f"
set ylabel "largest error of u, relative"
plot data index "units" using "scale":(of("one", "error")) with linespoints ls 2, \
     "" index "units" using "scale":(of("kept", "error")) \
         with linespoints ls 1, \
     "" index "units" using "scale":(of("one_from_g", "error")) \
         with points ls 2 pt 6 ps 1.3
unset multiplot
