# taylor.gp - what the first-order expansions of energy and force leave, over the
# size of the move: the lesson's own numbers.
# Expected: slope 2.
# Reads   data  table taylor (t energy force)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 560,400
set output out
set logscale xy
set format xy "10^{%T}"
set xlabel "size t of the move"
set ylabel "what is left"
plot for [what in "energy force"] reference index "taylor" using "t":what \
         with lines lw 7 lc rgb "#DDDDDD" notitle, \
     data index "taylor" using "t":"energy" with linespoints ls 1 \
         title "energy", \
     "" index "taylor" using "t":"force" with linespoints ls 2 title "force", \
     [0.004:0.25] 0.5 * x**2 with lines ls 8 title "slope 2"
