# scattered.gp - random starts, n = 4: where the runs of each method end; and an
# equilibrium without an inverted triangle that is not the square, its knots, and
# the start that led to it.
# Reads   data  tables scattered, tangled, knots
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,760
set output out
polygons(test, first) = sprintf( \
    "< awk -F'\t' '$0 == \"# tangled\" { on = 1; next } NF == 0 { on = 0 } \
     /^#/ { next } on == 1 { on = 2; print \"x\ty\"; next } \
     on == 2 && (%s) { for (k = 0; k < 4; k++) \
         print $(%d + 2 * (k %% 3)) \"\t\" $(%d + 1 + 2 * (k %% 3)); \
         print \"\" }' '%s'", test, first, first, data)
# a cell for each method and start: three amplitudes with both ends held, then
# two with the left one only
row(name) = name eq "notes" ? 0 : name eq "search" ? 1 : name eq "demand" ? 2 \
    : name eq "demand+search" ? 3 : 4
left(held, a) = held eq "both" ? (a < 0.9 ? 0 : a < 2 ? 1 : 2) : a < 2 ? 3.2 : 4.2
WIDE = 0.94
ways = "rest stable not_spd fails"
part(k) = k == 0 ? 0 : column(word(ways, k)) / column("seeds") + part(k - 1)
from(k) = left(strcol("held"), column("amplitude")) + WIDE * part(k - 1)
to(k) = left(strcol("held"), column("amplitude")) + WIDE * part(k)
# a part that is empty is not drawn, not even as a hair
box(k) = part(k) > part(k - 1) ? to(k) : NaN
percent(k) = 100.0 * column(word(ways, k)) / column("seeds")
# what a cell says: how many come back, or that none does
said(k) = percent(k) < 0.5 ? "" : k < 3 ? \
    sprintf(k < 2 ? "%.0f %%" : "%.0f %%\nknot", percent(k)) \
    : percent(k) < 99.9 ? "" : k == 3 ? "stops" : "fails"
# ... in the middle of its part, or beside it where it is narrow
middle(k) = to(k) - from(k) < 0.3 ? to(k) + 0.23 : 0.5 * (from(k) + to(k))
array Color[4] = ["#7FCFB4", "#A9D6F2", "#F3D59A", "#EBB4BE"]
stats data index "tangled" using (column("J_start") > 0 ? 0 : 1) nooutput
INVERTED = int(STATS_sum + 0.5)
set multiplot
unset key
unset border
unset tics
unset grid
set style fill solid noborder
set lmargin at screen 0.215
set rmargin at screen 0.99
set tmargin at screen 0.895
set bmargin at screen 0.415
set xrange [0:5.14]
set yrange [4.5:-0.5]
array Way[5] = ["notes' method", "line search", "projection\non demand", \
    "both: demand,\nline search", "projection always,\nline search"]
do for [m = 1:5] {
    set label m Way[m] at -0.08, m - (m > 2 ? 1.13 : 1.0) right
}
do for [i = 1:5] {
    set label 10 + i word("h/2 h 4h h 4h", i) \
        at (i < 4 ? i - 1 : i - 0.8) + 0.47, -0.72 center
}
set label 20 "both ends held, thrown by up to" at 1.47, -1.05 center
set label 21 "left end held, by up to" at 4.14, -1.05 center
plot for [k = 1:4] data index "scattered" using (box(k)):(row(strcol("method"))): \
         (from(k)):(to(k)):(row(strcol("method")) - 0.42): \
         (row(strcol("method")) + 0.42) with boxxyerror fc rgb Color[k], \
     for [k = 1:4] data index "scattered" using (middle(k)): \
         (row(strcol("method"))):(said(k)) with labels
unset label
set size ratio -1
# the held end, thick in both, which shows their scales
set arrow 1 from -1, -1 to -1, 1 nohead lw 5 lc rgb "black" front
set tmargin at screen 0.35
set bmargin at screen 0.02
set lmargin at screen 0.03
set rmargin at screen 0.49
set xrange [-3.3:2.6]
set yrange [-2.4:3]
set label 1 sprintf("a start, 4h (orange: inverted, %d of %d),\nat 2/5 of the size of its end", \
    INVERTED, STATS_records) at screen 0.26, screen 0.375 center
plot polygons("$7 > 0", 1) using 1:2 with filledcurves closed \
         fc rgb "#CFE3F0", \
     polygons("$7 <= 0", 1) using 1:2 with filledcurves closed \
         fc rgb "#F2C6A8", \
     polygons("1", 1) using 1:2 with lines lw 1 lc rgb "#0072B2"
set lmargin at screen 0.52
set rmargin at screen 0.98
set xrange [-1.3:1.05]
set yrange [-1.05:1.1]
set label 1 "its end: two knots, and stable" at screen 0.74, screen 0.375 center
plot polygons("1", 8) using 1:2 with filledcurves closed \
         fc rgb "#C00072B2", \
     polygons("1", 8) using 1:2 with lines lw 1.2 lc rgb "#0072B2", \
     data index "knots" using "x":"y" with points pt 6 ps 2.6 lw 3 \
         lc rgb "#C00000"
unset multiplot
