# first_step.gp - the corner of the mesh where Newton's method starts when the
# boundary moves by dg in a step, and its residuals from such a start.  Residuals
# below 1e-13 m are round-off, another one on each machine: drawn at 1e-13 m.
# Reads   data  tables starts, history_notes, history_lift
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,670 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
# the rows of table `starts` that pass the awk condition, as closed polygons
polygons(test) = sprintf( \
    "< awk -F'\t' '$0 == \"# starts\" { on = 1; next } NF == 0 { on = 0 } \
     /^#/ { next } on == 1 { on = 2; print \"x\ty\"; next } \
     on == 2 && (%s) { for (k = 0; k < 4; k++) \
         print $(4 + 2 * (k %% 3)) \"\t\" $(5 + 2 * (k %% 3)); \
         print \"\" }' '%s'", test, data)
set multiplot
set style fill solid noborder
unset grid
set size ratio -1
set tmargin at screen 0.995
set bmargin at screen 0.72
set xrange [-0.15:4.4]
set yrange [-0.15:3.15]
set xtics 2
set ytics 1
set xlabel "x / h"
set ylabel "y / h"
unset key
do for [k = 0:2] {
    set lmargin at screen 0.13 + 0.30 * k
    set rmargin at screen 0.375 + 0.30 * k
    if (k > 0) { unset ylabel }
    set label 1 "Δg = ".word("0.5 1.2 1.2", k + 1)." h".(k == 2 ? ",\nlifted" : \
        k == 1 ? ":\ninside out" : "") at graph 0, graph 1.40
    set arrow 1 from 0, -0.1 to 0, 3.1 nohead ls 8
    up = sprintf("$1 == %d && $10 > 1e-9", k)
    turned = sprintf("$1 == %d && $10 <= 1e-9", k)
    plot polygons(up) using 1:2 with filledcurves closed fc rgb "#CFE3F0", \
         polygons(k == 1 ? turned : up) using 1:2 with filledcurves closed \
             fc rgb (k == 1 ? "#D55E00" : "#CFE3F0"), \
         polygons(up) using 1:2 with lines lw 1 lc rgb "#0072B2", \
         polygons(k == 1 ? turned : up) using 1:2 with lines lw 1 \
             lc rgb (k == 1 ? "#7A3500" : "#0072B2")
}
unset label 1
unset arrow 1
set size noratio
set lmargin at screen 0.17
set rmargin at screen 0.975
set tmargin at screen 0.537
set bmargin at screen 0.124
set grid back ls 9
unset key
set logscale y
set xrange [-0.2:6.2]
set yrange [2e-14:20]
set xtics 2
set ytics 1e4
seen(y) = y > 1e-13 ? y : 1e-13
set mytics 1
set format y "10^{%T}"
set xlabel "iteration"
set ylabel "max |q| / max A_{ii} (m)" offset 1
set style textbox opaque noborder margins 0.4,0.4
set label 2 "notes' method: fails" at 4.1, 0.8 tc rgb "#D55E00" front boxed
set label 3 "lifted" at 2.6, 5e-11 tc rgb "#0072B2" front boxed
set label 4 "n = 56, cubic law" at graph 0, graph 1.08
plot data index "history_notes" using "iteration":(seen(column("residual"))) \
         with linespoints ls 2, \
     data index "history_lift" using "iteration":(seen(column("residual"))) \
         with linespoints ls 1
unset multiplot
