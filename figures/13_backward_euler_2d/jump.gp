# jump.gp - why the first step fails: the start of the notes after both ends
# jumped to the right by 0.85 h, the solution, and the iterations against the
# jump; crosses on top: no solution.
# Reads   data  tables guess, jump
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,760 enhanced font "Helvetica,17" \
    background rgb "white"
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
unset border
unset tics
set multiplot
set datafile nocolumnheaders
set datafile separator whitespace
set size ratio -1
set label 4 tc rgb "#003A5C"
set label 5 tc rgb "#8C3A00"
do for [moved = 0:1] {
    set lmargin at screen 0.13 + 0.49 * moved
    set rmargin at screen 0.38 + 0.49 * moved
    set tmargin at screen 0.95
    set bmargin at screen 0.755
    set label 1 (moved ? "the solution" : "start, jump 0.85 h") \
        at -0.85, 1.3
    set autoscale xy
    stats triangles(moved) using 3 nooutput
    set xrange [-1.1:1.35]
    set yrange [-1.1:1.1]
    set label 4 sprintf("J = %.2f", STATS_min) at -0.95, 0 right
    set label 5 sprintf("J = %.2f", STATS_max) at 1.33, 0
    plot triangles(moved) using 1:2:3 with filledcurves closed \
             fc palette, \
         triangles(moved) using 1:2 with lines lc rgb "black" lw 0.4
}

set datafile columnheaders
set datafile separator "\t"
unset label
set size noratio
set border 3 back ls 9
set grid back ls 9
set lmargin at screen 0.115
set rmargin at screen 0.98
set tmargin at screen 0.68
set bmargin at screen 0.11
set logscale x 2
set xrange [0.22:3.6]
set yrange [3:11]
set xtics nomirror textcolor rgb "black" ("1/4" 0.25, "1/2" 0.5, "1" 1, "2" 2)
set ytics nomirror textcolor rgb "black" 4, 1, 8
set xlabel "jump Δg / h"
set ylabel "iterations" offset 1
set object 1 rectangle from 0.22, 9.2 to 3.6, 11 fc rgb "#F3F3F3" \
    fs solid noborder behind
set label 2 "no solution found" at 0.24, 10.1 tc rgb "#555555"
set arrow 1 from 1, graph 0 to 1, graph 1 nohead ls 8
set style textbox opaque noborder margins 0.4,0.4
set label 3 "a jump of h puts the\nfirst column inside out" at 1.06, 8.35 front boxed
set label 4 "log" at 0.71, 8.4 right tc ls 1 front boxed
set label 5 "cubic" at 0.61, 6.42 tc ls 2 front boxed
set label 6 "both, from the lifted start" at 1.06, 4.4 front boxed
set label 7 "n = 8, Newton with Cholesky" at graph 0, graph 1.06
done(name) = strcol(name) eq "-" ? NaN : column(name)
lost(name, y) = strcol(name) eq "-" ? y : NaN
array Law[2] = ["log", "cubic"]
array Colour[2] = ["#0072B2", "#D55E00"]
array Hollow[2] = [6, 4]
plot for [k = 1:2] data index "jump" using "jump":(done(Law[k])) \
         with linespoints ls k ps 0.9, \
     for [k = 1:2] data index "jump" using "jump":Law[k]."_lifted" \
         with linespoints ls k dt 2 pt Hollow[k] ps 1.3, \
     for [k = 1:2] data index "jump" \
         using "jump":(lost(Law[k], k == 1 ? 10.5 : 9.8)) \
         with points pt 2 ps 1 lw 2 lc rgb Colour[k]
unset multiplot
