# jump.gp - why the first step fails: the start of the notes after both ends
# jumped to the right by 0.85 h, the solution, and the iterations against the
# jump; crosses on top: no solution.
# Reads   data  tables guess, jump
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,470
set output out

triangles(moved) = sprintf( \
    "< awk -F'\t' '$0 == \"# guess\" { on = 1; next } NF == 0 { on = 0 } \
     on && $1 == \"rigid\" && ($2 > 0) == %d { \
         print $4, $5, $3; print $6, $7, $3; \
         print $8, $9, $3; print $4, $5, $3; print \"\"; print \"\" }' '%s'", \
    moved, data)
set palette defined (0.1 "#003A5C", 0.5 "#0072B2", 0.85 "#A8D0EA", \
                     1 "#FFFFFF", 1.15 "#F5B98F", 1.5 "#D55E00", 1.9 "#8C3A00")
set cbrange [0.1:1.9]
set style fill solid noborder
unset key
unset grid
unset colorbox
set multiplot
set datafile nocolumnheaders
set datafile separator whitespace
set size ratio -1
set xrange [-1.1:1.35]
set yrange [-1.1:1.1]
set xtics 1
set ytics 1
set ylabel "x_2 (m)"
set lmargin at screen 0.075
set rmargin at screen 0.37
do for [moved = 0:1] {
    set tmargin at screen 0.94 - 0.455 * moved
    set bmargin at screen 0.575 - 0.455 * moved
    set label 1 moved ? "the solution" : "the notes' start, 0.85 h" \
        at graph 0, graph 1.07
    set xlabel moved ? "x_1 (m)" : ""
    set format x moved ? "%g" : ""
    if (moved) {
        set colorbox user origin screen 0.41, screen 0.2 \
            size screen 0.016, screen 0.65
        set cbtics 0.3 scale 0.5 offset -0.7
        set cblabel "J" offset -1.2
    }
    plot triangles(moved) using 1:2:3 with filledcurves closed \
             fc palette, \
         triangles(moved) using 1:2 with lines lc rgb "black" lw 0.4
}

set datafile columnheaders
set datafile separator "\t"
unset label 1
unset colorbox
set size noratio
set grid back ls 9
set key above left maxrows 2 samplen 3
set lmargin at screen 0.565
set rmargin at screen 0.985
set tmargin at screen 0.84
set bmargin at screen 0.12
set logscale x
set xrange [0.22:3.5]
set yrange [3:11]
set xtics (0.25, 0.5, 1, 2, 3)
set ytics 4, 1, 9
set xlabel "jump Δg / h"
set ylabel "iterations"
set label 2 "no solution found" at 0.235, 10.15
done(name) = strcol(name) eq "-" ? NaN : column(name)
lost(name, y) = strcol(name) eq "-" ? y : NaN
array Law[2] = ["log", "cubic"]
array Colour[2] = ["#0072B2", "#D55E00"]
array Hollow[2] = [6, 4]
plot for [k = 1:2] data index "jump" using "jump":(done(Law[k])) \
         with linespoints ls k ps 0.9 title Law[k], \
     for [k = 1:2] data index "jump" using "jump":Law[k]."_lifted" \
         with linespoints ls k dt 2 pt Hollow[k] ps 1.3 \
         title Law[k].", lifted", \
     for [k = 1:2] data index "jump" \
         using "jump":(lost(Law[k], k == 1 ? 10.5 : 9.8)) \
         with points pt 2 ps 1 lw 2 lc rgb Colour[k] notitle
unset multiplot
