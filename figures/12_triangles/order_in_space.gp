# order_in_space.gp - order two in space, one for the gradient, with the measured
# orders.
# Reads   data  table orders_space
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,400 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
stats data index "orders_space" using "order_L2" nooutput name "L"
stats data index "orders_space" using "order_gradient" nooutput name "G"
stats data index "orders_space" using "constant_L2" nooutput name "D"
unset key
set label 1 sprintf("u, in L²: order %.2f", L_max) at 0.06, 8e-3 tc ls 1 boxed
set label 2 sprintf("dashed: %.3f h²", D_max) at 0.2, 6e-3 boxed
set label 3 sprintf("gradient: order %.2f", G_max) at 0.06, 0.15 tc ls 2 boxed
set label 4 "dotted: gradient error\nof the interpolant" at 0.13, 0.052 boxed
set logscale xy
set format y "10^{%T}"
set xlabel "h (m)"
set ylabel "error: m² of u, m of the gradient"
set xrange [0.05:0.63]
set yrange [8e-4:0.5]
set xtics (0.0625, 0.125, 0.25, 0.5)
plot D_max * x**2 ls 8, \
     data index "orders_space" using "h":"L2" with linespoints ls 1, \
     "" index "orders_space" using "h":"interpolation" with lines ls 8 dt 3, \
     "" index "orders_space" using "h":"gradient" with points ls 2
