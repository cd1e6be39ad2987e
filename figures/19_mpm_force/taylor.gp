# taylor.gp - what the first-order expansions of energy and force leave, over the
# size of the move: the lesson's own numbers.
# Expected: slope 2.
# Reads   data  table taylor (t energy force)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 620,440 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set logscale xy
set format xy "10^{%T}"
set xlabel "size t of the move"
set ylabel "remainder of the\nenergy (J), of the force (N)"
unset key
set label 1 "force" at 0.02, 6e-3 right tc ls 2
set label 2 "energy" at 0.0135, 3.6e-4 tc ls 1
set label 3 "slope 2" at 0.03, 4e-5
plot for [what in "energy force"] reference index "taylor" using "t":what \
         with lines lw 7 lc rgb "#DDDDDD" notitle, \
     data index "taylor" using "t":"energy" with linespoints ls 1, \
     "" index "taylor" using "t":"force" with linespoints ls 2, \
     [0.004:0.25] 0.15 * x**2 with lines ls 8
