# crossing.gp - what is left over of a constant stress, over the spacing of the
# particles, at the worst place of the particles.
# Reads   data  table spacing (order s measured predicted)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,430
set output out
set logscale xy
set xrange [0.1:1.4]
set yrange [1e-5:2]
set xtics ("1/10" 0.1, "1/8" 0.125, "1/6" 1./6, "1/5" 0.2, "1/4" 0.25, \
    "1/3" 1./3, "1/2" 0.5, "1" 1)
set format y "10^{%T}"
set xlabel "spacing of the particles (cells)"
set ylabel "force left over / stress" offset 1
set rmargin 14
unset key
set label 1 "linear kernel" at 1.44, 1.4 tc ls 1
set label 2 "quadratic" at 1.44, 0.36 tc ls 2
set label 3 "cubic" at 1.44, 0.12 tc ls 3
set label 4 "grey: predicted" at 1.44, 2e-5 font ",12"
of(s, column_) = column("order") == s ? column(column_) : NaN
plot for [s = 2:3] data index "spacing" using "s":(of(s, "predicted")) \
         with lines lw 2.5 lc rgb "#BBBBBB", \
     for [s = 1:3] data index "spacing" using "s":(of(s, "measured")) \
         with points ls s ps 0.4
