# stability.gp - the largest explicit step against how far the last particle is
# within reach of a node, and the implicit step that ignores it.
# Reads   data  table critical
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,420
set output out
set logscale xy
set xrange [7e-7:0.4]
set yrange [8e-4:100]
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "how far the last particle is within reach of the next node (cells)"
set ylabel "largest step (h / c)"
unset key
set rmargin 3
set label 1 "one implicit step of 1/30 s (cubic: fails at 10⁻⁶),\n\
on this bar the price of 3 to 4 explicit ones" at 1.3e-6, 45
set label 2 "linear: falls to 0 like 2 √ε (dashed),\n\
with FLIP like √(2 ε) (dotted)" at 1.3e-6, 0.19 tc ls 1
set label 3 "quadratic: falls to 0.95 (with FLIP to 0.69)" at 1.3e-6, 0.6 tc ls 2
set label 4 "cubic: 1.47 to 1.49 (with FLIP 1.09 to 1.11)" at 1.3e-6, 2.4 tc ls 3
plot for [p = 1:3] data index "critical" every ::4*(p-1)::4*p-1 \
         using "eps":"grid" with linespoints ls p, \
     data index "critical" every ::0::3 \
         using "eps":"flip" with linespoints ls 1 dt 3, \
     data index "critical" every ::0::3 using "eps":"implicit" \
         with lines lw 2 lc rgb "#555555", \
     2 * sqrt(x) ls 8
