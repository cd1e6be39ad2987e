# compatibility.gp - how far b is from being compatible.
#
# Reads   data  table rules (h midpoint trapezoid gauss2); expected (e-1) h^2/24, (e-1) h^2/12, (e-1) h^4/4320
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 640,460 enhanced font "Helvetica,17"
set output out
unset key

stats data index "rules" using (log(column("h"))):\
    (log(abs(column("midpoint")))) name "M" nooutput
stats data index "rules" using (log(column("h"))):\
    (log(abs(column("trapezoid")))) name "T" nooutput
stats data index "rules" using (log(column("h"))):\
    (log(abs(column("gauss2")))) name "G" nooutput

E = exp(1) - 1
set logscale xy
set format y "10^{%T}"
set xlabel "element length h (-)"
set ylabel "defect of the linear system, | Σ b_i | (-)"
set xrange [0.013:0.32]
set yrange [1e-12:1]
set xtics ("1/64" 1./64, "1/32" 1./32, \
    "1/16" 1./16, "1/8" 1./8, "1/4" 1./4)
set ytics 1e-12, 100, 1
set label 1 sprintf("trapezoidal rule: order %.2f,\npredicted (e-1)h^2/12", T_slope) \
    at 0.0145, 0.15 tc ls 2 boxed
set label 2 sprintf("midpoint rule: order %.2f,\npredicted (e-1)h^2/24", M_slope) \
    at 0.0145, 2e-6 tc ls 1 boxed
set label 3 sprintf("two Gauss points: order %.2f,\npredicted (e-1)h^4/4320", G_slope) \
    at 0.3, 5e-11 right tc ls 3 boxed

plot data index "rules" using "h":(abs(column("trapezoid"))) \
         with points ls 2 ps 1, \
     "" index "rules" using "h":(abs(column("midpoint"))) \
         with points ls 1 ps 1, \
     "" index "rules" using "h":(abs(column("gauss2"))) \
         with points ls 3 ps 1.1, \
     E * x**2 / 12 with lines ls 8, \
     E * x**2 / 24 with lines ls 8, \
     E * x**4 / 4320 with lines ls 8
set output
