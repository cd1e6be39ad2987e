# price.gp - what PIC loses of a spin, over the visits that a transfer costs.
# Reads   data  table price
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,400
set output out
set logscale x
set xrange [900:200000]
set yrange [-0.06:1.08]
set ytics 0.2
set format x "10^{%T}"
set xlabel "nodes visited on one way"
set ylabel "fraction of the spin lost in 100 transfers"
unset key
set label 1 "linear" at 2.1e4, 0.15 tc ls 1
set label 2 "quadratic" at 4.7e4, 0.215 tc ls 2
set label 3 "cubic kernel" at 8.3e4, 0.285 tc ls 3
set label 4 "16 cells per metre" at 1.2e3, 1.04
set label 5 "32" at 4e3, 0.46 right
set label 6 "64" at 1.55e4, 0.12 right
set label 7 "APIC, with every kernel on every grid" at 2e5, 0.035 right
plot for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "visits":"pic_lost" with linespoints ls s ps 0.9, \
     0 with lines lw 2 lc rgb "black"
