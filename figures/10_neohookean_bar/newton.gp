# newton.gp - what Newton sees and what it does, step by
# step, and the law of its error.  Expected: slope 2 with the constant
# |P''/2P'| of the element with the largest error.
# Reads   data  table newton
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,420
set output out

stats data index "newton" using "k":"predicted" name "P" nooutput
stats data index "newton" using "k":"residual" name "R" nooutput
C = P_max_y
# what is there before round-off: an error above 1e-10
clean(name) = column("error") > 1e-10 ? column(name) : NaN
set multiplot layout 1,2 margins 0.085,0.985,0.13,0.80 spacing 0.11,0
set logscale y
set format y "10^{%T}"
set yrange [1e-10:1e3]
set ytics 1e3
set xlabel "step k"
set ylabel "size"
set xrange [-0.3:R_max_x + 0.3]
set xtics 1
plot data index "newton" using "k":(clean("residual")) with linespoints ls 1 \
         title "residual max |q_i| (N)", \
     "" index "newton" using "k":"increment" with linespoints ls 3 \
         title "increment max |Δu_i| (m)", \
     "" index "newton" using "k":(clean("error")) with linespoints ls 2 \
         title "error max |F_e - F_e^∞|"

set logscale xy
set format x "10^{%T}"
set xrange [1e-5:1]
set xtics 10
set yrange [1e-9:2]
set ytics 10
set xlabel "error before the step"
set ylabel "error after the step"
prev = NaN
plot C * x**2 ls 8 title sprintf("%.3f (error before)^2, expected", C), \
     data index "newton" using (p = prev, p):(prev = column("error"), \
         prev > 1e-10 ? prev : 1/0) \
         with linespoints ls 2 title "Newton, from right to left"
unset multiplot
