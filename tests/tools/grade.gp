# grade.gp - which mistakes a class made, and how often.
#
# Given with gnuplot -e: data (table `mistakes`: label count colour), out.

load "figures/style.gp"
stats data index "mistakes" using "count" nooutput
n = STATS_records
set terminal svg size 640,(90 + 20 * n) noenhanced font "Helvetica,13" \
    background rgb "white"
set output out
set style fill solid noborder
set xrange [0:1.1 * STATS_max]
set yrange [n - 0.4:-0.6]
set xtics 1
if (STATS_max > 12) set xtics autofreq
set grid noytics
set xlabel "files with it"
set tics scale 0
plot data index "mistakes" \
         using (0):0:(0):"count":($0 - 0.35):($0 + 0.35):"colour":\
         ytic(stringcolumn("label")) \
         with boxxyerror lc rgb variable notitle, \
     data index "mistakes" using "count":0:"count" \
         with labels left offset 0.5,0 notitle, \
     NaN with boxes lc rgb 0x0072B2 title "known mistake", \
     NaN with boxes lc rgb 0x999999 title "anything else"
set output
