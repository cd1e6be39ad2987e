# bifurcation.gp - the column: what Newton's method ends in over the load, and
# the shape at the last load, elements with a negative eigenvalue in orange.
# Reads   data  tables branches, shape, critical
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,690 enhanced font "Helvetica,19" \
    background rgb "white"
set output out
bears = system("awk -F'\t' '$0 == \"# critical\" { on = 1 } NF == 0 { on = 0 } \
    on && $1 == 80 { print $3 }' '".data."'") + 0.0
Euler = pi**2 / 300
at(what, state) = strcol("stable") eq state ? column(what) : NaN
set multiplot
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen 0.995
set bmargin at screen 0.749
set size ratio -1
set xrange [-1.0:1.0]
set yrange [-0.22:0.32]
unset tics
unset border
unset grid
unset key
set label 1 "the triangles; orange: a negative eigenvalue" \
    at graph 0.5, 0.06 center
filled(sign) = sprintf("< awk -F'\t' '$0 == \"# shape\" { on = 1; next } \
    NF == 0 { on = 0 } on && $7 == \"%s\" { print $1 \"\t\" $2; \
        print $3 \"\t\" $4; print $5 \"\t\" $6; print \"\" }' '%s'", sign, data)
set datafile nocolumnheaders
set style fill solid border lc rgb "white"
plot filled("yes") using 1:2 with filledcurves closed lw 0.5 fc rgb "#D55E00", \
     filled("no") using 1:2 with filledcurves closed lw 0.5 fc rgb "#0072B2"
set datafile columnheaders
unset label 1
set lmargin at screen 0.185
set rmargin at screen 0.95
set tmargin at screen 0.716
set bmargin at screen 0.127
set size noratio
set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid back ls 9
set xrange [0.02:0.05]
set yrange [-0.02:0.185]
set xtics 0.01
set ytics 0.05
set xlabel "how far each end moves inwards, e (m)"
set ylabel "deflection of the middle (m)"
set arrow 1 from Euler, graph 0 to Euler, graph 1 nohead ls 8
set arrow 2 from bears, graph 0 to bears, graph 0.42 nohead lw 1.5 \
    lc rgb "black"
set style textbox opaque noborder margins 0.4,0.4
set label 2 sprintf("Euler %.4f", Euler) at Euler, graph 0.93 right offset -1, 0 \
    front boxed
set label 3 sprintf("80 x 8 squares: %.4f", bears) at 0.0372, graph 0.35 front boxed
set label 4 "buckled: projected\non demand, pushed" at 0.0334, 0.168 left \
    front boxed
set label 5 "straight: K is\npositive definite" at 0.0263, 0.029 center \
    front boxed
set label 6 "straight: converged,\na saddle" at 0.0435, 0.029 center \
    textcolor rgb "#D55E00" front boxed
set label 7 "straight column:\nall 1280 triangles\nhave a negative\neigenvalue" at 0.0263, 0.112 center \
    front boxed
plot data index "branches" using "load":"buckled" with linespoints ls 1, \
     data index "branches" using "load":(at("straight", "stable")) \
         with points ls 3, \
     data index "branches" using "load":(at("straight", "saddle")) \
         with points ls 2
unset multiplot
