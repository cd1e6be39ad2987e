# stability.gp - the largest explicit step against the place of the last
# particle, and the implicit step that ignores it.
# Reads   data  table critical
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,400
set output out
set logscale xy
set xrange [7e-7:0.4]
set yrange [8e-4:40]
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "distance of the last particle from the node behind it (cells)"
set ylabel "largest step (h / c)"
unset key
set rmargin 20
set label 1 "an implicit step of 1/30 s costs as much as 3 to 4 explicit ones" \
    at 1e-6, 18 tc rgb "#555555"
set label 2 "2 √ε" at 2.2e-5, 1.9e-2 right
set label 3 "linear: falls\nto 0 like √ε" at 5e-4, 1.2e-2 tc ls 1
set label 4 "quadratic" at 0.45, 1.0 tc ls 2
set label 5 "cubic kernel" at 0.45, 2.0 tc ls 3
set label 6 "dotted: with FLIP" at 0.45, 0.35
plot for [p = 1:3] data index "critical" every ::4*(p-1)::4*p-1 \
         using "eps":"grid" with linespoints ls p, \
     for [p = 1:3] data index "critical" every ::4*(p-1)::4*p-1 \
         using "eps":"flip" with linespoints ls p dt 3, \
     data index "critical" every ::0::3 using "eps":"implicit" \
         with lines lw 2 lc rgb "#555555", \
     2 * sqrt(x) ls 8
