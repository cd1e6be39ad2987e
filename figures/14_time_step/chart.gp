# chart.gp - error of the swinging square after 0.1 s against the seconds and
# against the factorisations that a frame of 1/30 s takes.
# Expected: slopes -1 (first order) and -2 (second order).
# Reads   data  table chart (method per_frame status error factorisations
#               seconds), machine
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/chart.tsv"
if (!exists("out"))  out  = "figures/14_time_step/chart.svg"
load "figures/style.gp"
set terminal svg size 900,430
set output out
array Name[4] = ["symplectic Euler", "backward Euler", "midpoint", "BDF2"]
array Style[4] = [2, 1, 3, 4]
array Word[4] = ["symplectic", "backward", "midpoint", "bdf2"]
is(m) = stringcolumn("method") eq Word[m + 1]
ok(m, c) = is(m) && stringcolumn("status") eq "OK" ? column(c) : 1/0
# with how many steps in a frame a method does not get there
lost(m) = system("awk -F'\t' '$1 == \"".Word[m]."\" && $4 != \"OK\" \
    { said = said (said ? \", \" : \"\") $2 } END { print said }' '".data."'")

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
set multiplot layout 1,2 margins 0.075,0.985,0.165,0.965 spacing 0.10,0
set logscale xy
set format xy "10^{%T}"
set yrange [5e-5:6]
set ylabel "relative error of u at t = 0.1 s"
set label 9 machine(data) at screen 0.99,0.025 right font ",10" \
    textcolor rgb "#555555"
unset key
set xrange [5e-6:0.2]
set xlabel "computing time for a frame of 1/30 s (s)"
set arrow 1 from 1.0/30, 5e-5 to 1.0/30, 6 nohead ls 8 lw 1.5
set label 1 "33 ms" at 0.038, 8e-5 left
set label 2 "lost with so many steps in a frame:" at 6.5e-6, 3.6 font ",11"
set label 3 "symplectic Euler ".lost(1) at 6.5e-6, 2.2 tc ls 2 font ",11"
set label 4 "midpoint ".lost(3) at 3.5e-4, 2.2 tc ls 3 font ",11"
set label 5 "BDF2 ".lost(4) at 4e-3, 2.2 tc ls 4 font ",11"
set label 6 sprintf("symplectic\nEuler:\norder %.2f", Slope[1]) at 1e-4, 1e-2 right tc ls 2
set label 7 sprintf("backward Euler:\norder %.2f", Slope[2]) at 1.4e-3, 0.3 tc ls 1
set label 8 sprintf("midpoint:\norder %.2f", Slope[3]) at 1e-3, 4e-4 right tc ls 3
set label 10 sprintf("BDF2:\norder %.2f", Slope[4]) at 2.9e-3, 9e-3 tc ls 4
set label 11 "ring: the\ncheapest\nbelow 1 %" at 9e-6, 6e-4
plot for [m = 1:4] data index "chart" \
         using (ok(m - 1, "seconds")):(ok(m - 1, "error")) \
         with linespoints ls Style[m], \
     data index "chart" using (enough("seconds") <= least ? least : 1/0): \
         (enough("error")) with points pt 6 ps 2.2 lw 2 lc rgb "black"
unset label
unset arrow
set xrange [0.5:600]
set format x "%g"
set xtics ("none" 0.8, 2, 5, 10, 20, 50, 100, 200, 500)
set xlabel "factorisations in a frame of 1/30 s"
set label 1 "symplectic\nEuler" at 0.9, 1.2e-3 tc ls 2
set label 2 "backward Euler" at 40, 0.25 tc ls 1
set label 3 "midpoint" at 34, 2e-3 right tc ls 3
set label 4 "BDF2" at 120, 6e-3 tc ls 4
set label 5 "slope -1" at 580, 2.4e-2 right font ",11"
set label 6 "slope -2" at 550, 7e-4 right font ",11"
plot data index "chart" using (0.8 + 0 * ok(0, "error")):(ok(0, "error")) \
         with linespoints ls 2, \
     for [m = 2:4] data index "chart" \
         using (ok(m - 1, "factorisations")):(ok(m - 1, "error")) \
         with linespoints ls Style[m], \
     (x > 40 ? 4.0 / x : 1/0) with lines ls 8, \
     (x > 12 ? 16.0 / x**2 : 1/0) with lines ls 8 dt 4
unset multiplot
set output
