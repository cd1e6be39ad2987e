# storage.gp - what dense and banded storage cost: bytes and seconds against N.
#
# Reads   data  tables costs, times_dense, times_banded
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,400
set output out

dense = "times_dense"
banded = "times_banded"
# slopes that are due, from the first point of the dense matrix on, and a little
# below the last one of the band
stats data index dense using "N":"seconds" nooutput
N_dense = STATS_max_x
s_dense = STATS_max_y
N_first = STATS_min_x
s_first = STATS_min_y
stats data index banded using "N":"seconds" nooutput
N_banded = STATS_max_x
s_banded = STATS_max_y
# measured slopes, over the last factor 4
before(N) = column("N") == N / 4 ? column("seconds") : NaN
stats data index dense using (before(N_dense)) nooutput
p_dense = log(s_dense / STATS_max) / log(4)
stats data index banded using (before(N_banded)) nooutput
p_banded = log(s_banded / STATS_max) / log(4)

set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [10:1.5e6]
set xlabel "unknowns N"
set multiplot
set label 9 machine(data) at screen 0.98, screen 0.025 right font ",12" \
    textcolor rgb "#555555"
unset key
set tmargin at screen 0.96
set bmargin at screen 0.18
set lmargin at screen 0.10
set rmargin at screen 0.48
set ylabel "storage, bytes" offset 0.5
set yrange [100:1e13]
set label 1 "dense" at 1e5, 2e11 right tc ls 2
set label 2 "p = √N" at 2.4e4, 7e6 left tc ls 6
set label 3 "p = 1" at 1.5e4, 4e4 left tc ls 1
set label 4 "16 GiB" at 13, 4.5e10
plot data index "costs" using "N":"dense_bytes" with linespoints ls 2 lw 1, \
     data index "costs" using "N":"plane_bytes" with linespoints ls 6 lw 1, \
     data index "costs" using "N":"line_bytes" with linespoints ls 1 lw 1, \
     16 * 2.0**30 with lines ls 8
unset label
set lmargin at screen 0.60
set rmargin at screen 0.98
set ylabel "factor and solve, seconds"
set yrange [1e-7:1e2]
set label 1 sprintf("dense: N^{%.2f}", p_dense) at 8e2, 5e-2 left tc ls 2
set label 2 sprintf("p = 1: N^{%.2f}", p_banded) at 2e5, 7e-3 right tc ls 1
set label 3 "slope 3" at 2.5e3, 2e0 left
set label 4 "slope 1" at 6e4, 1e-4 left
plot data index dense using "N":"seconds" with linespoints ls 2 lw 1, \
     s_first * (x / N_first)**3 with lines ls 8, \
     data index banded using "N":"seconds" with linespoints ls 1 lw 1, \
     0.4 * s_banded * (x / N_banded) with lines ls 8
unset multiplot
set output
