# bifurcation.gp - the column: what Newton's method ends in over the load, and
# the shape at the last load, elements with a negative eigenvalue in orange.
# Reads   data  tables branches, shape, critical
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,600 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
bears = system("awk -F'\t' '$0 == \"# critical\" { on = 1 } NF == 0 { on = 0 } \
    on && $1 == 80 { print $3 }' '".data."'") + 0.0
Euler = pi**2 / 300
at(what, state) = strcol("stable") eq state ? column(what) : NaN
set multiplot
set lmargin at screen 0.115
set rmargin at screen 0.97
set tmargin at screen 0.99
set bmargin at screen 0.66
set size ratio -1
set xrange [-1.0:1.0]
set yrange [-0.13:0.3]
unset tics
unset border
unset grid
unset key
set label 1 "a dot for each triangle; orange: a negative eigenvalue" \
    at graph 0.5, 0.03 center
plot data index "shape" using (strcol("negative") eq "yes" ? \
         (column("x0") + column("x1") + column("x2")) / 3 : NaN): \
         ((column("y0") + column("y1") + column("y2")) / 3) \
         with points pt 7 ps 0.42 lc rgb "#D55E00", \
     data index "shape" using (strcol("negative") eq "no" ? \
         (column("x0") + column("x1") + column("x2")) / 3 : NaN): \
         ((column("y0") + column("y1") + column("y2")) / 3) \
         with points pt 7 ps 0.42 lc rgb "#0072B2"
unset label 1
set tmargin at screen 0.60
set bmargin at screen 0.13
set size noratio
set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid back ls 9
set xrange [0.02:0.05]
set yrange [-0.02:0.18]
set xtics 0.01
set ytics 0.05
set xlabel "how far each end moves inwards, e (m)"
set ylabel "deflection of the middle (m)"
set arrow 1 from Euler, graph 0 to Euler, graph 1 nohead ls 8
set arrow 2 from bears, graph 0 to bears, graph 0.32 nohead lw 1.5 \
    lc rgb "black"
set label 2 sprintf("Euler %.4f", Euler) at Euler, graph 0.93 right offset -1, 0
set label 3 sprintf("80 x 8 cells: %.4f", bears) at bears, graph 0.27 \
    offset 4, 0
set label 4 "buckled: projected on demand, pushed" at 0.0334, 0.167 left
set label 5 "straight: K is positive definite" at 0.0263, 0.013 center
set label 6 "straight: converged, a saddle" at 0.044, 0.013 center \
    textcolor rgb "#D55E00"
set label 7 "all 1280 triangles have\na negative eigenvalue" at 0.0263, 0.062 center
plot data index "branches" using "load":"buckled" with linespoints ls 1, \
     data index "branches" using "load":(at("straight", "stable")) \
         with points ls 3, \
     data index "branches" using "load":(at("straight", "saddle")) \
         with points ls 2
unset multiplot
