# cat.gp - a cat in the phase plane of one mode, every three steps of half a
# radian, by each method (grey: the start; the number: what is left of its
# area).
# Expected: areas 1, 1, and 1.25^-k for backward Euler.
# Reads   data  table cat
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/cat.tsv"
if (!exists("out"))  out  = "figures/14_time_step/cat.svg"
load "figures/style.gp"
set terminal svg size 640,690 enhanced font "Helvetica,19" \
    background rgb "white"
set output out
array Name[4] = ["symplectic Euler", "backward Euler", "midpoint", "BDF2"]
array Style[4] = [2, 1, 3, 4]
# The outline number j = 0..3 of method m has the rows 30 (4 (m - 1) + j) on.
row(m, j) = 30 * (4 * (m - 1) + j)
set multiplot
unset key
set size ratio -1
set xrange [-1.6:1.6]
set yrange [-1.6:1.6]
set xtics 1
set ytics 1
do for [m = 1:4] {
    col = (m - 1) % 2
    line = (m - 1) / 2
    set lmargin at screen 0.14 + 0.43 * col
    set rmargin at screen 0.54 + 0.43 * col
    set tmargin at screen 0.945 - 0.425 * line
    set bmargin at screen 0.58 - 0.425 * line
    set format x line == 1 ? "%g" : ""
    set format y col == 0 ? "%g" : ""
    set xlabel line == 1 ? "u" : ""
    set ylabel col == 0 ? "v / ω" : ""
    stats data index "cat" using "area" every ::row(m, 3)::row(m, 3) nooutput
    set label 1 sprintf("%s, area %.2f", Name[m], STATS_max) at graph 0.5, graph 1.08 \
        center
    # the cats' steps, in the first panel
    do for [j = 1:m == 1 ? 3 : 0] {
        stats data index "cat" using "u":"v" every ::row(m, j)::row(m, j)+29 nooutput
        set label 10 + j sprintf("%d", 3 * j) at STATS_mean_x, STATS_mean_y center front
    }
    plot data index "cat" using "u":"v" every ::row(m, 0)::row(m, 0)+29 \
             with filledcurves closed lc rgb "#bbbbbb", \
         for [j = 1:3] data index "cat" using "u":"v" \
             every ::row(m, j)::row(m, j)+29 \
             with filledcurves closed ls Style[m] fs transparent solid 0.35, \
         for [j = 1:3] data index "cat" using "u":"v" \
             every ::row(m, j)::row(m, j)+29 with lines ls Style[m] lw 1
    unset label
}
unset multiplot
set output
