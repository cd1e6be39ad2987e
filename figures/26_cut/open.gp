# open.gp - a strip that is cut from its side and pulled, and its factor Y.
# Expected: the factors of the handbook, and an error of order 1 in h on even meshes.
# Reads   data  tables strip, factor, error, graded
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,520 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
set datafile missing "-"
set multiplot
unset grid
set lmargin at screen 0.02
set rmargin at screen 0.37
set bmargin at screen 0.03
set tmargin at screen 0.97
set size ratio -1
unset border
unset tics
unset key
plot data index "strip" using "x":"y":"to_x":"to_y" with vectors nohead \
    lc rgb "#0072B2" lw 0.7
set size noratio
set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid back ls 9
set lmargin at screen 0.47
set rmargin at screen 0.97
set tmargin at screen 0.85
set bmargin at screen 0.60
set key above left vertical maxrows 3 reverse Left
set xlabel "length of the cut over the width, a/b"
set ylabel "Y(a/b)"
set xrange [0.15:0.65]
set ytics 1
set yrange [1:4.5]
plot data index "factor" using "r":"handbook" with lines ls 8 \
         title "handbook", \
     data index "factor" using "r":"computed" with points ls 1 \
         title "n = 40", \
     data index "factor" using "r":"extrapolated" with points ls 2 \
         title "extrapolated from n = 20, 40"
set tmargin at screen 0.46
set bmargin at screen 0.14
unset key
set logscale xy
set ytics (0.01, 0.1)
set xlabel "flops to factor K"
set ylabel "missing part of Y, a/b = 0.5"
set xrange [1e5:3e9]
set yrange [0.004:0.3]
set format x "10^{%T}"
set label 1 "order 1: flops^{-1/4}" at 3e8,0.12 center
set label 2 "even" at 4e8,0.042 tc ls 1
set label 3 "graded" at 4e7,0.014 right tc ls 3
plot data index "error" using "flops":"error" with linespoints ls 1, \
     "" index "graded" using "flops":"error" with linespoints ls 3, \
     0.02533 * (956244702.0 / x) ** 0.25 with lines ls 8
unset multiplot
