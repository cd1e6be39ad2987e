# jump.gp - why the first step fails: the start of the notes after both ends
# jumped to the right by 0.85 h, the solution, and the iterations against the
# jump; crosses on top: no solution.
# Reads   data  tables guess, jump
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 980,400
set output out

triangles(moved) = sprintf( \
    "< awk -F'\t' '$0 == \"# guess\" { on = 1; next } NF == 0 { on = 0 } \
     on && $1 == \"rigid\" && ($2 > 0) == %d { \
         print $4, $5, $3; print $6, $7, $3; print \"\"; \
         print $8, $9, $3; print $8, $9, $3; print \"\"; print \"\" }' '%s'", \
    moved, data)
set palette defined (0.1 "#8C3A00", 0.5 "#D55E00", 0.85 "#F5B98F", \
                     1 "#FFFFFF", 1.15 "#A8D0EA", 1.5 "#0072B2", 1.9 "#003A5C")
set cbrange [0.1:1.9]
set pm3d map corners2color c1 border lc rgb "black" lw 0.4
unset key
unset grid
unset colorbox
set border 15 front ls 9
set multiplot
set datafile nocolumnheaders
set datafile separator whitespace
set size ratio -1
set xrange [-1.1:1.35]
set yrange [-1.1:1.1]
set xtics 1
set ytics 1
set xlabel "{x_1} (m)"
set ylabel "{x_2} (m)" offset -1
set tmargin at screen 0.86
set bmargin at screen 0.16
set lmargin at screen 0.075
set rmargin at screen 0.335
set label 1 "the notes' start" at graph 0, graph 1.06
splot triangles(0) using 1:2:3 with pm3d
set lmargin at screen 0.345
set rmargin at screen 0.605
set label 1 "the solution"
unset ylabel
set format y ""
set colorbox user origin screen 0.625, screen 0.19 size screen 0.012, screen 0.62
set cbtics 0.3 scale 0.5 offset -0.7
set cblabel "J" offset -1.2
splot triangles(1) using 1:2:3 with pm3d

set datafile columnheaders
set datafile separator "\t"
unset label 1
unset colorbox
set size noratio
set grid back ls 9
set border 3 back ls 9
set key above left maxrows 2 samplen 2 font ",12"
set lmargin at screen 0.745
set rmargin at screen 0.985
set tmargin at screen 0.80
set logscale x
set xrange [0.22:3.5]
set yrange [3:11]
set format y "%g"
set xtics (0.25, 0.5, 1, 2, 3)
set ytics 4, 1, 9
set xlabel "jump Δg / h"
set ylabel "iterations" offset 0.5
set label 2 "no solution found" at 0.235, 10.15 font ",11"
done(name) = strcol(name) eq "-" ? NaN : column(name)
lost(name, y) = strcol(name) eq "-" ? y : NaN
plot data index "jump" using "jump":(done("log")) with linespoints ls 1 \
         title "log", \
     "" index "jump" using "jump":(lost("log", 10.5)) with points pt 2 ps 1 \
         lw 2 lc rgb "#0072B2" notitle, \
     "" index "jump" using "jump":(done("cubic")) with linespoints ls 2 \
         title "cubic", \
     "" index "jump" using "jump":(lost("cubic", 9.8)) with points pt 2 ps 1 \
         lw 2 lc rgb "#D55E00" notitle, \
     "" index "jump" using "jump":"log_lifted" with linespoints ls 3 \
         title "log, lifted", \
     "" index "jump" using "jump":"cubic_lifted" with linespoints ls 4 \
         title "cubic, lifted"
unset multiplot
