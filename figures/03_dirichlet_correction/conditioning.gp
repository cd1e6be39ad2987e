# conditioning.gp - A before and after the correction, and
# what the diagonal entry does to the condition number.
#
# Reads   data  tables A, A_corrected (i j value), condition (n kept one)
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 760,350 enhanced font "Helvetica,16" \
    background rgb "white"
set output out

set multiplot
set size ratio -1
set xrange [-0.7:6.7]
set yrange [6.7:-0.7]
set xtics 1 scale 0
set ytics 1 scale 0
unset grid
set border 15 back ls 9
unset key
set xlabel "column j"
set ylabel "row i" offset 1.8

# rows and columns of the prescribed nodes 0, 4, 6
do for [k in "0 4 6"] {
    set object rectangle from k - 0.5, -0.5 to k + 0.5, 6.5 behind \
        fc rgb "#F0E442" fs transparent solid 0.35 noborder
    set object rectangle from -0.5, k - 0.5 to 6.5, k + 0.5 behind \
        fc rgb "#F0E442" fs transparent solid 0.35 noborder
}
entry(v) = v == 0 ? NaN : 1
set lmargin at screen 0.065
set rmargin at screen 0.325
set tmargin at screen 0.90
set bmargin at screen 0.2
set label 1 "as assembled: singular" at graph 0, graph 1.06
plot data index "A" using "j":(entry(column("value"))*column("i")) \
         with points pt 5 ps 1.6 lc rgb "#0072B2"
set lmargin at screen 0.405
set rmargin at screen 0.665
set label 1 "corrected at 0, 4, 6"
plot data index "A_corrected" \
         using "j":(entry(column("value"))*column("i")) \
         with points pt 5 ps 1.6 lc rgb "#0072B2"

unset object
unset label 1
set size noratio
set lmargin at screen 0.765
set rmargin at screen 0.97
set tmargin at screen 0.96
set bmargin at screen 0.2
set border 3 back ls 9
set grid back ls 9
set xrange [3:45]
set yrange [10:1e6]
set logscale xy
set xtics (4, 8, 16, 32) scale 0.5
set ytics auto scale 0.5
set format y "10^{%T}"
set xlabel "elements n"
set ylabel "condition number" offset 1
set label 1 "diagonal 1" at 3.6, 2.5e5 tc ls 2 boxed
set label 2 "diagonal kept" at 44, 26 right tc ls 1 boxed
# 64 elements are a prediction of the chapter, and the formula an exercise
plot data index "condition" using "n":"one" every ::::3 \
         with linespoints ls 2, \
     ""   index "condition" using "n":"kept" every ::::3 \
         with linespoints ls 1
unset multiplot
set output
