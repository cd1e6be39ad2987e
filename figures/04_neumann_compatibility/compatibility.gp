# compatibility.gp - how far b is from being compatible.
#
# Reads   data  tables compatibility (h sum_b), rules (h midpoint trapezoid
#               gauss2); expected (e-1) h^2/24, (e-1) h^2/12, (e-1) h^4/4320
# Writes  out   SVG
load "figures/style.gp"
set output out
set key maxrows 4

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

plot data index "rules" using "h":(abs(column("trapezoid"))) \
         with points ls 2 ps 1 \
         title sprintf("trapezoid rule, measured order %.2f", T_slope), \
     "" index "compatibility" using "h":(abs(column("sum_b"))) \
         with points ls 1 ps 1 \
         title sprintf("midpoint rule, measured order %.2f", M_slope), \
     "" index "rules" using "h":(abs(column("gauss2"))) \
         with points ls 3 ps 1.1 \
         title sprintf("two Gauss points, measured order %.2f", G_slope), \
     E * x**2 / 12 with lines ls 8 \
         title "predicted: (e-1)h^2/12, (e-1)h^2/24, (e-1)h^4/4320 (dashed, slopes 2, 2, 4)", \
     E * x**2 / 24 with lines ls 8 notitle, \
     E * x**4 / 4320 with lines ls 8 notitle
set output
