# crossing.gp - what is left over of a constant stress, over the spacing of the
# particles, at the worst place of the particles; and over what it costs, the
# visits of nodes per cell of the plane: (particles per axis (p + 1))^2.
# Reads   data  tables spacing (order s measured predicted), ppc
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 780,420
set output out
set multiplot
set logscale xy
set xrange [0.1:1.4]
set yrange [1e-5:2]
set xtics ("1/10" 0.1, "1/6" 1./6, "1/4" 0.25, \
    "1/3" 1./3, "1/2" 0.5, "1" 1)
set format y "10^{%T}"
set xlabel "spacing of the particles (cells)"
set ylabel "force left over / stress" offset 1
set lmargin at screen 0.1
set rmargin at screen 0.50
set bmargin at screen 0.14
set tmargin at screen 0.93
unset key
set label 1 "linear kernel" at 0.36, 1.1 right tc ls 1
set label 2 "quadratic" at 0.108, 0.033 tc ls 2
set label 3 "cubic" at 0.7, 7e-3 center tc ls 3
set label 4 "grey: predicted" at 1.35, 1.7e-5 right
# at 1, 1/2, ... it is 0: holes in the line of the linear kernel
do for [k = 1:9] {
    set label 10 + k "" at 1./k, 1./k point pt 7 ps 1.1 lc rgb "white" front
    set label 20 + k "" at 1./k, 1./k point ls 1 pt 6 ps 0.9 lw 1.5 front
}
of(s, column_) = column("order") == s ? column(column_) : NaN
plot for [s = 2:3] data index "spacing" using "s":(of(s, "predicted")) \
         with lines lw 2.5 lc rgb "#BBBBBB", \
     for [s = 1:3] data index "spacing" using "s":(of(s, "measured")) \
         with points ls s ps 0.4
unset label
unset ylabel
set format y ""
set format x "%g"
set lmargin at screen 0.56
set rmargin at screen 0.985
set xrange [10:9000]
set xtics (16, 64, 256, 1024, 4096)
set xlabel "nodes visited per cell of the plane"
set label 1 "linear" at 1150, 0.16 tc ls 1
set label 2 "quadratic" at 750, 0.04 tc ls 2
set label 3 "cubic" at 400, 4e-4 tc ls 3
set arrow 1 from 64, 1.3e-5 to 64, 1.5 nohead ls 8
set label 5 "64 visits" at 70, 1.6e-5
plot for [p = 1:3] data index "ppc" \
         using ((column("ppc") * (p + 1))**2):word("linear quadratic cubic", p) \
         with linespoints ls p ps 0.9
unset multiplot
