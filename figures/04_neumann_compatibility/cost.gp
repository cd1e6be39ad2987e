# cost.gp - the energy error against the samples of the load, for four ways to an
# answer.
# Reads   data  table cost
# Writes  out   SVG
load "figures/style.gp"
set output out
set logscale xy
set xrange [3:3000]
set yrange [3e-4:0.4]
set format x "%g"
set format y "10^{%T}"
set xlabel "samples of f"
set ylabel "error in the energy norm, relative"
of(way) = strcol("way") eq way ? column("error") : 1/0
set key above left maxrows 4 samplen 2
# |u''| and |u'| of u = x - e^x in L2
C = sqrt((exp(2) - 1) / 24) / sqrt(1 - 2*(exp(1) - 1) + (exp(2) - 1) / 2)
set label 1 "twice the samples, the same error" at 34, 0.045 left
set arrow 1 from 18, 0.037 to 30, 0.037 size 1.2, 20 head filled lc rgb "#666666"
plot data index "cost" using "samples":(of("excess")) with linespoints ls 4 \
         title "flux of 0.1 too much, pinned", \
     "" index "cost" using "samples":(of("pinned")) with linespoints ls 6 ps 1.5 \
         title "midpoint rule, pinned", \
     "" index "cost" using "samples":(of("midpoint")) with linespoints ls 1 \
         title "midpoint rule, projected", \
     "" index "cost" using "samples":(of("gauss2")) with linespoints ls 3 \
         title "two Gauss points, projected", \
     C / x with lines ls 8 title "h |u''| / √12, predicted"
