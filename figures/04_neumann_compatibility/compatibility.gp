# compatibility.gp - how far b is from being compatible.
#
# Reads   data  tables compatibility (h sum_b), rules (h midpoint trapezoid
#               gauss2); expected (e-1) h^2/24, (e-1) h^2/12, (e-1) h^4/4320
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,400
set output out
unset key

stats data index "compatibility" using (log(column("h"))):\
    (log(abs(column("sum_b")))) name "M" nooutput
stats data index "rules" using (log(column("h"))):\
    (log(abs(column("trapezoid")))) name "T" nooutput
stats data index "rules" using (log(column("h"))):\
    (log(abs(column("gauss2")))) name "G" nooutput

E = exp(1) - 1
set logscale xy
set format y "10^{%T}"
set xlabel "element length h (-)"
set ylabel "defect of the linear system, | Σ b_i | (-)"
set xrange [0.003:0.35]
set yrange [1e-12:1e-1]
set xtics ("1/256" 1./256, "1/128" 1./128, "1/64" 1./64, "1/32" 1./32, \
    "1/16" 1./16, "1/8" 1./8, "1/4" 1./4)
set ytics 1e-12, 100, 1
set label 1 sprintf("trapezoid rule: order %.2f, predicted (e-1)h^2/12", T_slope) \
    at 0.0035, 3e-2 tc ls 2
set label 2 sprintf("midpoint rule: order %.2f, predicted (e-1)h^2/24", M_slope) \
    at 0.0035, 6e-8 tc ls 1
set label 3 sprintf("two Gauss points: order %.2f,\npredicted (e-1)h^4/4320", G_slope) \
    at 0.34, 1e-10 right tc ls 3

plot data index "rules" using "h":(abs(column("trapezoid"))) \
         with points ls 2 ps 1, \
     "" index "compatibility" using "h":(abs(column("sum_b"))) \
         with points ls 1 ps 1, \
     "" index "rules" using "h":(abs(column("gauss2"))) \
         with points ls 3 ps 1.1, \
     E * x**2 / 12 with lines ls 8, \
     E * x**2 / 24 with lines ls 8, \
     E * x**4 / 4320 with lines ls 8
set output
