# mode.gp - one mode: its path in the plane of u and v / omega by each method
# (dashed: exact), and the error after omega T = 2.385 against omega dt.
# Expected: slopes 1, 1, 2, 2 with the constants of [eq:mode-constants].
# Reads   data  tables mode, orders
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/mode.tsv"
if (!exists("out"))  out  = "figures/14_time_step/mode.svg"
load "figures/style.gp"
set terminal svg size 640,1080 enhanced font "Helvetica,19" \
    background rgb "white"
set output out
array Name[4] = ["symplectic", "backward", "midpoint", "BDF2"]
array Column[4] = ["symplectic", "backward", "midpoint", "bdf2"]
array Style[4] = [2, 1, 3, 4]
array Due[4] = [1, 1, 2, 2]
array Constant[4]
array Slope[4]
do for [m = 1:4] {
    stats data index "orders" using "predicted" every ::9*m-9::9*m-9 nooutput
    Constant[m] = STATS_max
    stats data index "orders" using "order" every ::9*m-2::9*m-1 nooutput
    Slope[m] = STATS_mean
}
set multiplot
# one small panel for each, with its name above
unset key
set size ratio -1
set xrange [-1.3:1.3]
set yrange [-1.3:1.3]
set xtics 1
set ytics 1
set parametric
set trange [0:2*pi]
do for [m = 1:4] {
    col = (m - 1) % 2
    row = (m - 1) / 2
    set lmargin at screen 0.14 + 0.43 * col
    set rmargin at screen 0.54 + 0.43 * col
    set tmargin at screen 0.965 - 0.27 * row
    set bmargin at screen 0.735 - 0.27 * row
    set label 1 sprintf("%s: order %.2f", Name[m], Slope[m]) at graph 0.5, graph 1.08 center
    set format x row == 1 ? "%g" : ""
    set format y col == 0 ? "%g" : ""
    set xlabel row == 1 ? "u" : ""
    set ylabel col == 0 ? "v / ω" : ""
    plot cos(t), sin(t) with lines ls 8 lw 1.5, \
         data index "mode" using Column[m]."_u":Column[m]."_v" \
             every ::0::24 with linespoints ls Style[m] lw 1 ps 0.5
}
unset parametric
unset label
set lmargin at screen 0.18
set rmargin at screen 0.955
set tmargin at screen 0.365
set bmargin at screen 0.075
unset key
set label 1 "dashed: predicted" at 0.025, 3e-6 left
set size noratio
set logscale xy
set format xy "10^{%T}"
set xtics autofreq
set ytics autofreq
set xrange [2e-4:1]
do for [m = 1:4] {
    set label m + 1 Name[m] at 1.8e-3, Constant[m] * 2.1e-3**Due[m] right tc ls Style[m]
}
set yrange [1e-7:3]
set xlabel "ω Δt"
set ylabel "error at ω T = 2.385"
plot for [m = 1:4] data index "orders" using "w_dt":"error" \
         every ::9*m-9::9*m-1 with points ls Style[m], \
     for [m = 1:4] (x < 2e-3 ? NaN : Constant[m] * x**Due[m]) with lines ls 8
unset multiplot
set output
