# moved.gp - what is missing of the opening of a cut against flops, its mean and its
# standard deviation over 24 slanting blades: along edges, and with moved vertices.
# Reads   data  table opening
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,330 enhanced font "Helvetica,15" background rgb "white"
set output out
set logscale x
set xrange [4e4:1.2e7]
set format x "10^{%T}"
set yrange [-0.05:0.5]
set ytics 0.1
set xlabel "flops to factor K and to solve"
set ylabel "missing part of the opening"
plot data index "opening" using (0.94 * column("flops")):"edges":"edges_spread" \
         with yerrorbars ls 1 title "along edges", \
     "" index "opening" using (1.06 * column("flops")):"moved":"moved_spread" \
         with yerrorbars ls 2 title "with moved vertices", \
     "" index "opening" using "flops":(0.46):(sprintf("n = %d", column("n"))) \
         with labels notitle, \
     0 with lines ls 8 notitle
