# crossing.gp - what is left over of a constant stress, over the spacing of the
# particles, at the worst place of the particles; and over what it costs, the
# visits of nodes per cell of the plane: (particles per axis (p + 1))^2.
# Reads   data  tables spacing (order s measured predicted), ppc
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,980 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
set multiplot
set logscale xy
set xrange [0.1:1.4]
set yrange [1e-5:2]
set xtics ("1/10" 0.1, "1/6" 1./6, "1/4" 0.25, \
    "1/3" 1./3, "1/2" 0.5, "1" 1)
set format y "10^{%T}"
set xlabel "spacing of the particles (cells)"
set ylabel "force left over / stress"
set lmargin at screen 0.185
set rmargin at screen 0.97
set tmargin at screen 0.985
set bmargin at screen 0.575
unset key
set label 1 "linear kernel" at 0.19, 0.55 right tc ls 1
set label 2 "quadratic" at 0.145, 0.03 center tc ls 2
set label 3 "cubic" at 0.7, 8e-3 center tc ls 3
set label 4 "grey:\npredicted" at 0.57, 4e-5
# at 1, 1/2, ... it is 0: holes in the line of the linear kernel
do for [k = 1:9] {
    set label 10 + k "" at 1./k, 1./k point pt 7 ps 1.1 lc rgb "white" front
    set label 20 + k "" at 1./k, 1./k point ls 1 pt 6 ps 0.9 lw 1.5 front
}
set label 5 "here 0" at 0.93, 0.5 center tc ls 1
of(s, column_) = column("order") == s ? column(column_) : NaN
plot for [s = 2:3] data index "spacing" using "s":(of(s, "predicted")) \
         with lines lw 2.5 lc rgb "#BBBBBB", \
     for [s = 1:3] data index "spacing" using "s":(of(s, "measured")) \
         with points ls s ps 0.4
unset label
set format x "%g"
set tmargin at screen 0.485
set bmargin at screen 0.085
set xrange [10:9000]
set xtics (16, 64, 256, 1024, 4096)
set xlabel "nodes visited per cell of the plane"
set ylabel "force left over / stress,\nat the worst stretch"
set label 1 "linear" at 1250, 0.16 tc ls 1
set label 2 "quadratic" at 800, 0.037 tc ls 2
set label 3 "cubic" at 420, 6e-4 right tc ls 3
set arrow 1 from 64, 1.3e-5 to 64, 1.5 nohead ls 8
set label 5 "64 visits" at 72, 1.8e-5
plot for [p = 1:3] data index "ppc" \
         using ((column("ppc") * (p + 1))**2):word("linear quadratic cubic", p) \
         with linespoints ls p ps 0.9
unset multiplot
