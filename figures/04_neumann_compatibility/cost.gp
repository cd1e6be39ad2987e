# cost.gp - the energy error against the samples of the load, for four ways to an
# answer.
# Reads   data  table cost
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 640,420 enhanced font "Helvetica,14"
set output out
set logscale xy
set xrange [3:3000]
set yrange [3e-4:0.4]
set format x "%g"
set format y "10^{%T}"
set xlabel "samples of f"
set ylabel "error in the energy norm, relative"
of(way) = strcol("way") eq way ? column("error") : 1/0
unset key
# |u''| and |u'| of u = x - e^x in L2
C = sqrt((exp(2) - 1) / 24) / sqrt(1 - 2*(exp(1) - 1) + (exp(2) - 1) / 2)
set label 1 "twice the samples,\nthe same error" at 40, 0.055 left boxed
set arrow 1 from 18, 0.037 to 30, 0.037 size 1.2, 20 head filled lc rgb "#666666"
set label 2 "a flux of 0.1 too much, pinned" at 60, 0.15 left textcolor ls 4 boxed
set label 3 "two Gauss points,\nprojected" at 400, 0.006 left textcolor ls 3 boxed
set label 4 "midpoint rule, projected\n(dots) or pinned (circles)" \
    at 4, 0.0026 left textcolor ls 1 boxed
set label 5 "dashed: h |u''| / √12, predicted" at 4, 0.0009 left boxed
plot data index "cost" using "samples":(of("excess")) with linespoints ls 4, \
     "" index "cost" using "samples":(of("pinned")) with linespoints ls 6 ps 1.5, \
     "" index "cost" using "samples":(of("midpoint")) with linespoints ls 1, \
     "" index "cost" using "samples":(of("gauss2")) with linespoints ls 3, \
     C / x with lines ls 8
