# tolerance.gp - what a looser tolerance of the linear solves costs and saves:
# Newton's increments and CG's iterations per time step.
# Reads   data  table tolerance
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,760
set output out
of(rule, what) = strcol("rule") eq rule ? column(what) : NaN

set multiplot layout 2,1 margins 0.105,0.975,0.075,0.985 spacing 0,0.1
set logscale x
set grid noxtics
unset key
set label 1 "one K for several increments" at 1e-9, 4.5 tc ls 2
set label 2 "K anew for each increment" at 1e-9, 2.6 tc ls 1
set xrange [3e-11:1.2]
set xtics ("10^{-10}" 1e-10, "10^{-8}" 1e-8, "10^{-6}" 1e-6, "10^{-4}" 1e-4, \
           "10^{-2}" 1e-2, "1" 1)
set xlabel "tolerance of the linear solves"
set format y "%g"
set ylabel "increments per step" offset 0.5
set yrange [0:8]
plot data index "tolerance" using (of("newton", "tolerance")):"increments" \
         with linespoints ls 1 lw 2.5, \
     "" index "tolerance" using (of("chord", "tolerance")):"increments" \
         with linespoints ls 2 dt 2
unset label
set label 1 "one K for several increments" at 6e-9, 32.7 tc ls 2
set label 2 "K anew for each increment" at 5e-11, 17.5 tc ls 1
set ylabel "iterations of CG per step" offset 0.5
set yrange [0:40]
plot data index "tolerance" using (of("newton", "tolerance")):"per_step" \
         with linespoints ls 1 lw 2.5, \
     "" index "tolerance" using (of("chord", "tolerance")):"per_step" \
         with linespoints ls 2 dt 2
unset multiplot
