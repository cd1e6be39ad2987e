# knot.gp - a body that was let go long ago and is still: all J > 0, two knots;
# and the triangles of the right one alone, enlarged, whose outer corners are
# numbered in their order.
# Reads   data  table body
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 820,450
set output out
set multiplot
set palette defined (0 "#002F4F", 0.5 "#0072B2", 1 "#FFFFFF", 1.5 "#D55E00", \
                     2 "#7A3300")
set cbrange [0:2]
set label 1 "J" at graph 1.095, 1.05 center
set cbtics 0.5
triangles = sprintf("< awk -F'\t' '$1 == \"triangle\" { \
    print $3, $4, $2; print $5, $6, $2; print \"\"; \
    print $7, $8, $2; print $7, $8, $2; print \"\"; print \"\" }' '%s'", data)
rings = sprintf("< awk -F'\t' '$1 == \"knot\" { print $3, $4, 0 }' '%s'", data)
# The last knot and the corners around it, from the first back to it: place, and
# number.
around = sprintf("< awk -F'\t' '$1 == \"triangle\" { t[++n] = $0 } \
    $1 == \"knot\" { at = $3 \" \" $4 } \
    END { for (i = 1; i <= n; i++) { split(t[i], f, FS); \
              for (k = 0; k < 3; k++) p[k] = f[3 + 2 * k] \" \" f[4 + 2 * k]; \
              for (k = 0; k < 3; k++) if (p[k] == at) { \
                  first = p[(k + 1) %% 3]; after[first] = p[(k + 2) %% 3] } } \
          p[0] = first; print at, p[0], 1; \
          for (k = 1; k < 10 && p[k - 1] in after; k++) { \
              p[k] = after[p[k - 1]]; print at, p[k], k + 1; \
              if (p[k] == first) exit } }' '%s'", data)
set datafile nocolumnheaders
set datafile separator whitespace
set pm3d map corners2color c1 border lc rgb "#555555" lw 0.5
unset key
unset grid
set border 15 front ls 9
set size ratio -1
set xrange [-1.05:1.2]
set yrange [-1.05:1.05]
set lmargin at screen 0.06
set rmargin at screen 0.585
set tmargin at screen 0.93
set bmargin at screen 0.13
set xtics 1
set ytics 1
set xlabel "x_1  (m)"
set ylabel "x_2  (m)" offset -1
splot triangles using 1:2:3 with pm3d, \
      rings using 1:2:3 with points pt 6 ps 2.6 lw 3 lc rgb "#C00000"
unset label
unset border
unset tics
unset xlabel
unset ylabel
set lmargin at screen 0.68
set rmargin at screen 0.995
set xrange [0.13:0.62]
set yrange [0.44:1.04]
set label 1 "the right knot, enlarged" at 0.375, 1.02 center
set label 2 "first time round" at 0.375, 0.475 center tc ls 1
set label 3 "second time round" at 0.375, 0.445 center tc ls 2
out_of(at, corner) = at + 1.1 * (corner - at)
plot around using 1:2:($3-$1):($4-$2) with vectors nohead lw 1 lc rgb "#777777", \
     around using 3:($5 <= 4 ? $4 : NaN) with lines ls 1 lw 3, \
     around using 3:($5 >= 4 ? $4 : NaN) with lines ls 2 lw 3, \
     around using (out_of($1, $3)):(out_of($2, $4)):\
         ($5 <= 6 ? sprintf("%d", $5) : "") with labels, \
     around every ::0::0 using 1:2 with points pt 6 ps 2.6 lw 3 lc rgb "#C00000"
unset multiplot
