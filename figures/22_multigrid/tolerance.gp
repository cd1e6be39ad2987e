# tolerance.gp - what a looser tolerance of the linear solves costs and saves:
# Newton's increments and CG's iterations per time step.
# Reads   data  table tolerance
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 780,370
set output out
of(rule, what) = strcol("rule") eq rule ? column(what) : NaN

set multiplot layout 1,2 margins 0.075,0.985,0.145,0.96 spacing 0.085,0
set logscale x
unset key
set label 1 "one K for several increments" at 1e-9, 4.5 tc ls 2
set label 2 "K anew for each increment" at 1e-9, 2.9 tc ls 1
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
set label 1 "one K" at 2e-9, 33 tc ls 2
set label 2 "K anew" at 1.6e-10, 21.5 tc ls 1
set ylabel "iterations of CG per step" offset 0.5
set yrange [0:40]
plot data index "tolerance" using (of("newton", "tolerance")):"per_step" \
         with linespoints ls 1 lw 2.5, \
     "" index "tolerance" using (of("chord", "tolerance")):"per_step" \
         with linespoints ls 2 dt 2
unset multiplot
