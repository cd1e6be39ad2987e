# storage.gp - what dense and banded storage cost: bytes and seconds against N.
#
# Reads   data  tables costs, times_dense, times_banded
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,450
set output out

dense = "times_dense"
banded = "times_banded"
# slopes that are due, through the last point of each series
stats data index dense using "N":"seconds" nooutput
N_dense = STATS_max_x
s_dense = STATS_max_y
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
set label 1 machine(data) at screen 0.98, screen 0.025 right font ",10" \
    textcolor rgb "#555555"
set tmargin at screen 0.76
set bmargin at screen 0.17
set lmargin at screen 0.10
set rmargin at screen 0.48
set key at screen 0.07, screen 0.985 left top vertical maxrows 4 reverse Left
set ylabel "storage, bytes" offset 0.5
set yrange [100:1e13]
plot data index "costs" using "N":"dense_bytes" with linespoints ls 2 lw 1 \
         title "dense: 8 N^2", \
     data index "costs" using "N":"plane_bytes" with linespoints ls 6 lw 1 \
         title "banded, p = √N: 8 N(p + 1)", \
     data index "costs" using "N":"line_bytes" with linespoints ls 1 lw 1 \
         title "banded, p = 1: 16 N", \
     16 * 2.0**30 with lines ls 8 title "16 GiB"
unset label 1
set lmargin at screen 0.60
set rmargin at screen 0.98
set key at screen 0.57, screen 0.985 left top vertical maxrows 4 reverse Left
set ylabel "factor and solve, seconds"
set yrange [1e-7:1e2]
plot data index dense using "N":"seconds" with linespoints ls 2 lw 1 \
         title sprintf("dense: measured N^{%.2f}", p_dense), \
     s_dense * (x / N_dense)**3 with lines ls 8 title "due: N and N^3", \
     data index banded using "N":"seconds" with linespoints ls 1 lw 1 \
         title sprintf("banded, p = 1: measured N^{%.2f}", p_banded), \
     s_banded * (x / N_banded) with lines ls 8 notitle
unset multiplot
set output
