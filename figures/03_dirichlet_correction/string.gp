# string.gp - the displacement, and the forces that hold the prescribed nodes:
# the lesson's own numbers.
# Reads   data  table nodes (x u reaction)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 560,400
set output out
unset key
unset grid
set label 1 "arrows: forces along the bar,\ndrawn upwards if they act to the right" \
    at graph 0.1, graph 0.94 tc rgb "#D55E00"
set xrange [-0.1:1.1]
set offsets 0, 0, 0.1, 0.1
set xlabel "x"
set ylabel "u"
f(r) = abs(r) > 1e-6 ? r / 10000 : NaN      # 1000: 0.1
plot reference index "nodes" using "x":"u" with lines lw 7 lc rgb "#DDDDDD", \
     data index "nodes" using "x":"u" with linespoints ls 1, \
     data index "nodes" using "x":"u":(0):(f(column("reaction"))) \
         with vectors head filled size 0.02,20 lw 2.5 lc rgb "#D55E00", \
     data index "nodes" using "x":(column("u") + f(column("reaction")) \
         + (column("reaction") > 0 ? 0.05 : -0.05)): \
         (sprintf("r = %.4g", column("reaction"))) with labels tc rgb "#D55E00"
