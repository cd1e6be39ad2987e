# order.gp - TODO: what the picture shows.
# Reads   data  table error
# Writes  out   SVG
load "figures/style.gp"
set output out
set logscale xy
set xrange [1.5:90]
set format y "10^{%T}"
set xlabel "pieces n"
set ylabel "error"
plot data index "error" using "n":"error" with linespoints ls 1 \
         title "trapezium rule", \
     1 / (6 * x**2) with lines ls 8 title "1/6n²"
