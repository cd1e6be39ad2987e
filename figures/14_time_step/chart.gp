# chart.gp - error of the swinging square after 0.1 s against the seconds that a
# frame of 1/30 s takes; a ring round the cheapest run below 1 %.
# Expected: slopes -1 (first order) and -2 (second order).
# Reads   data  table chart (method status error seconds), machine
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/chart.tsv"
if (!exists("out"))  out  = "figures/14_time_step/chart.svg"
load "figures/style.gp"
set terminal svg size 680,450 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
array Style[4] = [2, 1, 3, 4]
array Word[4] = ["symplectic", "backward", "midpoint", "bdf2"]
is(m) = stringcolumn("method") eq Word[m + 1]
ok(m, c) = is(m) && stringcolumn("status") eq "OK" ? column(c) : 1/0
array Slope[4]
do for [m = 1:4] {
    stats data index "chart" using (ok(m - 1, "error")) every ::9*m-2::9*m-2 \
        nooutput
    e = STATS_max
    stats data index "chart" using (ok(m - 1, "error")) every ::9*m-1::9*m-1 \
        nooutput
    Slope[m] = log(e / STATS_max) / log(2)
}
enough(c) = stringcolumn("status") eq "OK" && column("error") <= 0.01 ? \
    column(c) : 1/0
stats data index "chart" using (enough("seconds")) nooutput
least = STATS_min
set margins screen 0.13, screen 0.97, screen 0.185, screen 0.97
set logscale xy
set format xy "10^{%T}"
set yrange [5e-5:2]
set ylabel "relative error of u at t = 0.1 s"
set label 9 machine(data) at screen 0.99,0.025 right font ",10" \
    textcolor rgb "#555555"
unset key
set xrange [1.5e-5:0.1]
set xlabel "computing time for a frame of 1/30 s (s)"
set arrow 1 from 1.0/30, 5e-5 to 1.0/30, 2 nohead ls 8 lw 1.5
set label 1 "real\ntime" at 0.037, 2.5e-4 left
set style textbox opaque noborder margins 0.4,0.4
set label 6 sprintf("symplectic\nEuler:\norder %.2f", Slope[1]) at 1.1e-4, 1e-2 \
    right tc ls 2 front boxed
set label 7 sprintf("backward Euler:\norder %.2f", Slope[2]) at 1.7e-3, 0.27 tc ls 1 \
    front boxed
set label 8 sprintf("midpoint:\norder %.2f", Slope[3]) at 1.15e-3, 5e-4 right tc ls 3 \
    front boxed
set label 10 sprintf("BDF2:\norder %.2f", Slope[4]) at 3.3e-3, 1.1e-2 tc ls 4 front boxed
plot for [m = 1:4] data index "chart" \
         using (ok(m - 1, "seconds")):(ok(m - 1, "error")) \
         with linespoints ls Style[m], \
     data index "chart" using (enough("seconds") <= least ? least : 1/0): \
         (enough("error")) with points pt 6 ps 2.2 lw 2 lc rgb "black"
set output
