# wound.gp - the wound, opened, on its mesh; and how far off the opening is,
# against the flops of one factorisation.
# Reads   data  tables net, mesh
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,680 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
unset key
set multiplot
set size ratio -1
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen 0.99
set bmargin at screen 0.56
unset border
unset tics
unset grid
set xrange [-55:55]
set yrange [-3:48]
at(state, c) = strcol("when") eq state ? column(c) : NaN
dx(state) = at(state, "x1") - at(state, "x0")
dy(state) = at(state, "y1") - at(state, "y0")
set arrow 1 from -48,-1.2 to 48,-1.2 nohead lw 5 lc rgb "#888888"
set label 1 "bone" at 0,-2.9 center
set arrow 3 from 13,36 to 25,42 lw 3 lc rgb "#B5484F"
set arrow 4 from -13,36 to -25,42 lw 3 lc rgb "#B5484F"
set label 6 "retractors" at 0,42 center tc rgb "#B5484F"
set arrow 5 from 38,-2.6 to 48,-2.6 nohead lw 2 lc rgb "black"
set label 7 "10 mm" at 49,-2.7
plot data index "net" using (at("rest", "x0")):(at("rest", "y0")): \
         (dx("rest")):(dy("rest")) with vectors nohead lw 1 lc rgb "#CCCCCC", \
     data index "net" using (at("open", "x0")):(at("open", "y0")): \
         (dx("open")):(dy("open")) with vectors nohead lw 1.3 lc rgb "#22739F"
unset arrow 1
unset label 1
unset arrow 3
unset arrow 4
unset arrow 5
unset label 6
unset label 7
set size noratio
set lmargin at screen 0.13
set rmargin at screen 0.97
set tmargin at screen 0.52
set bmargin at screen 0.10
set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid
set logscale xy
set xrange [8e3:3e8]
set yrange [0.15:60]
set format x "10^{%T}"
set format y "%g"
set xlabel "flops of one factorisation"
set ylabel "opening too small by (%)" offset 1
set arrow 2 from 8e3,5 to 3e8,5 nohead ls 8
set label 2 "5 %" at 1.1e4,5.9
set label 3 "linear triangles" at 2.2e6,14 tc ls 2
set label 4 "quadratic triangles" at 5e5,1.3 right tc ls 1
set label 5 "r = 3" at 2.6e6,3 tc ls 1
plot data index "mesh" using "linear_flops":"linear" with linespoints ls 2, \
     data index "mesh" using "quadratic_flops":"quadratic" \
         with linespoints ls 1
unset multiplot
