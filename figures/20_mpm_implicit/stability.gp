# stability.gp - the longest stable explicit step against how far the last particle is
# within reach of a node, without transfers and with FLIP, and the implicit step that ignores it.
# Reads   data  table critical
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,520 enhanced font "Helvetica,17" \
    background rgb "white"
set output out
set logscale xy
set xrange [4e-7:0.5]
set yrange [8e-4:60]
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "ε: how far within reach of the next node (cells)"
set ylabel "longest stable step (h / c)"
unset key
set lmargin at screen 0.15
set rmargin at screen 0.97
grey = "#555555"
set label 5 "cubic: MAX\\_ITERATIONS" at 1.3e-6, 5.5 tc ls 3
set label 1 "one implicit step of 1/30 s (no limit)" at 1e-3, 17 center tc rgb grey
set label 2 "linear: falls to 0\nlike 2 √ε (dashed)" at 2.5e-6, 9e-2 tc ls 1
set label 7 "with FLIP like √(2 ε)" at 1.1e-4, 4e-3 tc ls 1
set label 3 "quadratic: falls to 0.95 (FLIP: to 0.69)" at 1.3e-6, 0.42 tc ls 2
set label 4 "cubic: 1.47 to 1.49 (FLIP: 1.09 to 1.11)" at 1.3e-6, 2.4 tc ls 3
plot for [p = 1:3] data index "critical" every ::4*(p-1)::4*p-1 \
         using "eps":"grid" with linespoints ls p, \
     for [p = 1:3] data index "critical" every ::4*(p-1)::4*p-1 \
         using "eps":"flip" with lines ls p dt 3, \
     data index "critical" every ::0::3 using "eps":"implicit" \
         with lines lw 2 lc rgb grey, \
     data index "critical" every ::11::11 using "eps":"implicit" with points ls 3 pt 2 ps 1.2 lw 2, \
     2 * sqrt(x) ls 8
