# stability.gp - the largest explicit step against the place of the last
# particle, and the implicit step that ignores it.
# Reads   data  table critical
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,430
set output out
set logscale xy
set xrange [7e-7:0.4]
set yrange [8e-4:40]
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "distance of the last particle from the node behind it (cells)"
set ylabel "largest step (h / c)"
set key above left maxrows 2 samplen 2.5
set label 1 "an implicit step of 1/30 s: four systems (linear, quadratic)" \
    at 1e-6, 18 tc rgb "#555555"
set label 2 "2 √ε" at 2.2e-5, 1.6e-2
plot for [p = 1:3] data index "critical" every ::4*(p-1)::4*p-1 \
         using "eps":"grid" with linespoints ls p \
         title word("linear quadratic cubic", p).": grid alone", \
     for [p = 1:3] data index "critical" every ::4*(p-1)::4*p-1 \
         using "eps":"flip" with linespoints ls p dt 3 \
         title word("linear quadratic cubic", p).": with FLIP", \
     data index "critical" every ::0::3 using "eps":"implicit" \
         with lines lw 2 lc rgb "#555555" notitle, \
     2 * sqrt(x) ls 8 notitle
