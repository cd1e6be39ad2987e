# realtime.gp - the longest step of a whole swing, with and without a cap of
# systems (realtime_all.gp: and the largest n that is in time).
# Reads   data  tables swing (systems n worst_ms), machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,440
set output out
of(word) = strcol("systems") eq word ? column("n") : NaN

set margins screen 0.12, screen 0.97, screen 0.175, screen 0.965
unset key
set label 9 machine(data) at screen 0.01,0.025 left textcolor rgb "#555555"
set logscale xy
set grid noxtics
set xtics (16, 24, 32, 48, 64)
set xrange [14:72]
set yrange [0.2:1e4]
set xlabel "squares per side n"
set ylabel "longest step (ms)" offset 2
set label 1 "without a budget:\nup to 300 systems per step" at 15,4500 tc ls 2
set label 2 "at most 8 systems per step" at 28,4 tc ls 1
set label 3 "1/30 s: in time below" at 28,47
plot data index "swing" using (of("all")):"worst_ms" with linespoints ls 2, \
     data index "swing" using (of("capped")):"worst_ms" with linespoints ls 1, \
     1000.0 / 30.0 with lines ls 8
