# order_in_space.gp - order two in space, one for the gradient, with the measured
# orders.
# Reads   data  table orders_space
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,440
set output out
stats data index "orders_space" using "order_L2" nooutput name "L"
stats data index "orders_space" using "order_gradient" nooutput name "G"
stats data index "orders_space" using "constant_L2" nooutput name "D"
set key above left maxrows 4 samplen 2
set logscale xy
set format y "10^{%T}"
set xlabel "h (m)"
set ylabel "error"
set xrange [0.05:0.63]
set yrange [8e-4:0.5]
set xtics (0.0625, 0.125, 0.25, 0.5)
plot D_max * x**2 ls 8 title sprintf("%.3f h^2, expected slope 2", D_max), \
     data index "orders_space" using "h":"L2" with linespoints ls 1 \
         title sprintf("u in {L^2} (m^2), order %.2f", L_max), \
     "" index "orders_space" using "h":"interpolation" with lines ls 8 dt 3 \
         title "gradient of the interpolant", \
     "" index "orders_space" using "h":"gradient" with points ls 2 \
         title sprintf("gradient of {u_h} (m), order %.2f", G_max)
