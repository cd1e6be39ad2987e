# knot.gp - a body that was let go long ago and is still: all J > 0, two knots.
# Reads   data  table body
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,450
set output out
set palette defined (0 "#002F4F", 0.5 "#0072B2", 1 "#FFFFFF", 1.5 "#D55E00", \
                     2 "#7A3300")
set cbrange [0:2]
set label 1 "J" at graph 1.095, 1.05 center
set cbtics 0.5
triangles = sprintf("< awk -F'\t' '$1 == \"triangle\" { \
    print $3, $4, $2; print $5, $6, $2; print \"\"; \
    print $7, $8, $2; print $7, $8, $2; print \"\"; print \"\" }' '%s'", data)
rings = sprintf("< awk -F'\t' '$1 == \"knot\" { print $3, $4, 0 }' '%s'", data)
set datafile nocolumnheaders
set datafile separator whitespace
set pm3d map corners2color c1 border lc rgb "#555555" lw 0.5
unset key
unset grid
set border 15 front ls 9
set size ratio -1
set xrange [-1.05:1.2]
set yrange [-1.05:1.05]
set lmargin at screen 0.09
set rmargin at screen 0.86
set tmargin at screen 0.93
set bmargin at screen 0.13
set xtics 1
set ytics 1
set xlabel "x_1  (m)"
set ylabel "x_2  (m)" offset -1
splot triangles using 1:2:3 with pm3d, \
      rings using 1:2:3 with points pt 6 ps 2.6 lw 3 lc rgb "#C00000"
