# kink.gp - errors of the solution against element length, in both norms: a smooth
# problem, and a jump of beta inside an element.
# Expected slopes: 2 and 1; 1 (with the right mean of beta 1.5) and 0.5.
#
# Reads   data  tables solution, jump
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 800,530 enhanced font "Helvetica,16.5"
set output out

set logscale xy
set xrange [5.5e-3:2.6]
set yrange [5e-6:2]
set xtics ("1/128" 1./128, "1/32" 1./32, "1/8" 1./8)
set xlabel "element length h"
set ylabel "error of the solution"
set format y "10^{%T}"
unset key
before(x) = x < 0.2 ? x : NaN
array Rule[3] = ["midpoint", "trapezoid", "gauss2"]
array Mean[3] = ["sampled", "exact", "harmonic"]
array Style[3] = [1, 4, 5]
set multiplot
set lmargin at screen 0.125
set rmargin at screen 0.505
set tmargin at screen 0.91
set bmargin at screen 0.155

set title "all data smooth" offset 0,-0.5
set label 1 "energy, any rule:\nslope 1" at 0.0065, 0.6 left boxed
set label 2 "L^2: slope 2" at 0.04, 3e-5 left boxed
set label 3 "trapezoidal" at 0.29, 0.05 left textcolor ls 2 boxed
set label 4 "midpoint" at 0.29, 0.0235 left textcolor ls 1 boxed
set label 5 "Gauss" at 0.29, 0.011 left textcolor ls 3 boxed
plot for [k = 1:3] data index "solution" using "h":"L2_".Rule[k] \
         with linespoints ls k, \
     for [k = 1:3] data index "solution" using "h":"energy_".Rule[k] \
         with linespoints ls k, \
     2.4 * before(x) with lines ls 8, 0.12 * before(x)**2 with lines ls 8

# right: the energy above, L2 below, each with an axis of its own
set title "β jumps inside an element" offset 0,-0.5
unset ylabel
unset xlabel
set xrange [5.5e-3:4.6]
set yrange [0.03:0.6]
set ytics (0.05, 0.1, 0.2, 0.4)
set format y "%g"
set lmargin at screen 0.61
set rmargin at screen 0.98
set tmargin at screen 0.91
set bmargin at screen 0.59
set ylabel "energy error" offset 0.5,0
set label 1 "slope 0.5" at 0.0075, 0.3 left boxed
unset label 2
set label 3 "midpoint" at 0.29, 0.215 left textcolor ls 1 boxed
set label 4 "exact mean" at 0.29, 0.15 left textcolor ls 4 boxed
set label 5 "harmonic mean" at 0.29, 0.31 left textcolor ls 5 boxed
plot for [k = 1:3] data index "jump" using "h":"energy_".Mean[k] \
         with linespoints ls Style[k], \
     0.95 * before(x)**0.5 with lines ls 8

unset title
set xlabel "element length h"
set yrange [2e-5:0.2]
set ytics auto
set format y "10^{%T}"
set tmargin at screen 0.53
set bmargin at screen 0.155
set ylabel "L^2  error" offset 0.5,0
set label 1 "slope 1" at 0.0085, 2.5e-2 left boxed
set label 2 "slope 1.5" at 0.055, 2e-4 left boxed
set label 3 "midpoint" at 0.29, 0.09 left textcolor ls 1 boxed
set label 4 "exact mean" at 0.29, 0.033 left textcolor ls 4 boxed
set label 5 "harmonic mean" at 0.29, 0.0125 left textcolor ls 5 boxed
plot for [k = 1:3] data index "jump" using "h":"L2_".Mean[k] \
         with linespoints ls Style[k], \
     0.45 * before(x) with lines ls 8, 0.04 * before(x)**1.5 with lines ls 8
unset multiplot
