# crossing.gp - what is left over of a constant stress: over the spacing of the
# particles, over their number, and as an acceleration over h.
# Reads   data  tables spacing, ppc, refine
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 1000,430
set output out
set multiplot
set tmargin at screen 0.78
set bmargin at screen 0.14
set logscale xy
array Name[3] = ["linear", "quadratic", "cubic"]

set lmargin at screen 0.075
set rmargin at screen 0.43
set xrange [0.1:1.4]
set yrange [1e-5:2]
set xtics ("0.1" 0.1, "1/8" 0.125, "1/5" 0.2, "1/4" 0.25, "1/3" 1./3, \
    "1/2" 0.5, "1" 1)
set format y "10^{%T}"
set xlabel "spacing of the particles (cells)"
set ylabel "force left over / stress" offset 1
set key above left vertical maxrows 4 samplen 2
of(s, column_) = column("order") == s ? column(column_) : NaN
plot for [s = 1:3] data index "spacing" using "s":(of(s, "measured")) \
         with points ls s ps 0.35 title Name[s], \
     for [s = 2:3] data index "spacing" using "s":(of(s, "predicted")) \
         with lines ls 8 dt 1 title (s == 3 ? "Poisson summation" : "")

set lmargin at screen 0.505
set rmargin at screen 0.705
set xrange [1.7:19]
set xtics (2, 4, 8, 16)
set xlabel "particles per cell"
set yrange [1e-4:2]
unset ylabel
unset key
set label 1 "linear, slope 1" at 4.6,1.0 font ",12" tc ls 1
set label 2 "quadratic, 2" at 5.5,0.13 font ",12" tc ls 2
set label 3 "cubic, 3" at 6,0.009 font ",12" tc ls 3
plot for [s = 1:3] data index "ppc" using "ppc":Name[s] with points ls s ps 1, \
     for [s = 1:3] [2:17] (s == 1 ? 1.94 : s == 2 ? 1.55 : 0.82) / x**s \
         with lines ls 8
unset label

set lmargin at screen 0.79
set rmargin at screen 0.985
set xrange [0.006:0.16]
set yrange [100:1e5]
set xtics ("1/128" 1./128, "1/32" 1./32, "1/8" 1./8)
set xlabel "h (m)"
set ylabel "acceleration (m/s²)" offset 1
set label 1 "linear" at 0.028,2.2e4 font ",12" tc ls 1
set label 2 "quadratic" at 0.0072,4.6e3 font ",12" tc ls 2
set label 3 "cubic" at 0.028,1.2e3 font ",12" tc ls 3
plot for [s = 1:3] data index "refine" using "h":Name[s] with linespoints ls s
unset multiplot
