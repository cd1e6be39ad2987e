# chart.gp - error of the swinging square after 0.1 s against the seconds and
# against the factorisations that a frame of 1/30 s takes.
# Expected: slopes -1 (first order) and -2 (second order).
# Reads   data  table chart (method per_frame status error factorisations
#               seconds), machine
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/chart.tsv"
if (!exists("out"))  out  = "figures/14_time_step/chart.svg"
load "figures/style.gp"
set terminal svg size 920,500
set output out
array Name[4] = ["symplectic Euler", "backward Euler", "midpoint", "BDF2"]
array Style[4] = [2, 1, 3, 4]
array Word[4] = ["symplectic", "backward", "midpoint", "bdf2"]
is(m) = stringcolumn("method") eq Word[m + 1]
ok(m, c) = is(m) && stringcolumn("status") eq "OK" ? column(c) : 1/0
bad(m, c) = is(m) && stringcolumn("status") ne "OK" ? column(c) : 1/0
top = 2.5

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
set multiplot layout 1,2 margins 0.075,0.985,0.165,0.75 spacing 0.10,0
set logscale xy
set format xy "10^{%T}"
set yrange [5e-5:6]
set ylabel "relative error of u at t = 0.1 s"
set label 9 machine(data) at screen 0.99,0.025 right font ",10" \
    textcolor rgb "#555555"
set key at screen 0.07, screen 0.985 left top vertical maxrows 6 reverse Left \
    samplen 2
set xrange [5e-6:0.2]
set xlabel "computing time for a frame of 1/30 s (s)"
set arrow 1 from 1.0/30, 5e-5 to 1.0/30, 6 nohead ls 8 lw 1.5
set label 1 "33 ms" at 0.038, 8e-5 left
set arrow 2 from 5e-6, 1.3 to 0.2, 1.3 nohead ls 9
set label 2 "did not get there" at 0.03, top right font ",11"
plot for [m = 1:4] data index "chart" \
         using (ok(m - 1, "seconds")):(ok(m - 1, "error")) \
         with linespoints ls Style[m] \
         title sprintf("%s: order %.2f", Name[m], Slope[m]), \
     for [m = 1:4] data index "chart" \
         using (bad(m - 1, "seconds")):(top) with points ls Style[m] pt 2 \
         ps 0.9 title (m == 1 ? "failed (symplectic Euler: unbounded)" : ""), \
     data index "chart" using (enough("seconds") <= least ? least : 1/0): \
         (enough("error")) with points pt 6 ps 2.2 lw 2 lc rgb "black" \
         title "cheapest below 1 %"
unset label 9
unset label 1
unset arrow 1
set key at screen 0.60, screen 0.985 left top vertical maxrows 4 reverse Left \
    samplen 2
set xrange [0.5:600]
set format x "%g"
set xtics ("none" 0.8, 2, 5, 10, 20, 50, 100, 200, 500)
set arrow 2 from 0.5, 1.3 to 600, 1.3 nohead ls 9
set label 2 "did not get there" at 400, top right
set xlabel "factorisations in a frame of 1/30 s"
plot data index "chart" using (0.8 + 0 * ok(0, "error")):(ok(0, "error")) \
         with linespoints ls 2 notitle, \
     data index "chart" using (0.8):(bad(0, "per_frame") > 0 ? top : 1/0) \
         with points ls 2 pt 2 ps 0.9 notitle, \
     for [m = 2:4] data index "chart" \
         using (ok(m - 1, "factorisations")):(ok(m - 1, "error")) \
         with linespoints ls Style[m] notitle, \
     for [m = 2:4] data index "chart" \
         using (bad(m - 1, "factorisations")):(top) with points ls Style[m] \
         pt 2 ps 0.9 notitle, \
     (x > 40 ? 4.0 / x : 1/0) with lines ls 8 title "slope -1", \
     (x > 12 ? 16.0 / x**2 : 1/0) with lines ls 8 dt 4 title "slope -2"
unset multiplot
set output
