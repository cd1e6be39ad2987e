# grade.gp - which mistakes a class made, and how often.
#
# Given with gnuplot -e: out, and data: table `mistakes`, label count colour row,
# and in table `rest` how many kinds are not among them.

load "figures/style.gp"
stats data index "rest" using "kinds" nooutput
rest = STATS_max
stats data index "mistakes" using "row" nooutput
last = STATS_max
stats data index "mistakes" using "count" nooutput
set terminal svg size 640,(110 + 20 * last) noenhanced font "Helvetica,13" \
    background rgb "white"
set output out
set style fill solid noborder
set xrange [0:1.1 * STATS_max]
set yrange [last + 0.6:-0.6]
set xtics 1
if (STATS_max > 12) set xtics autofreq
set grid noytics
set xlabel "files with it" . \
    (rest > 0 ? sprintf("; %d rarer kinds are not drawn", rest) : "")
set tics scale 0
plot data index "mistakes" \
         using (0):"row":(0):"count":(column("row") - 0.35):\
         (column("row") + 0.35):"colour":\
         ytic(stringcolumn("label")) \
         with boxxyerror lc rgb variable notitle, \
     data index "mistakes" using "count":"row":"count" \
         with labels left offset 0.5,0 notitle, \
     NaN with boxes lc rgb 0x0072B2 title "known mistake", \
     NaN with boxes lc rgb 0x999999 title "anything else"
set output
