# 12_backward_euler_2d_orders.gp - order one in time, order two in space (one
# for the gradient), with the measured orders.
# Reads   data  tables orders_time, orders_space
# Writes  out   SVG
if (!exists("data")) data = "build/data/12_backward_euler_2d.tsv"
if (!exists("out"))  out  = "figures/12_backward_euler_2d_orders.svg"
load "figures/style.gp"
set terminal svg size 900,440
set output out
stats data index "orders_time" using "order" nooutput name "T"
stats data index "orders_space" using "order_L2" nooutput name "L"
stats data index "orders_space" using "order_gradient" nooutput name "G"
stats data index "orders_time" using "constant" nooutput name "C"
stats data index "orders_space" using "constant_L2" nooutput name "D"
set multiplot layout 1,2 margins 0.085,0.985,0.13,0.78 spacing 0.1,0
set key above left maxrows 4 samplen 2
set logscale xy
set format y "10^{%T}"
set xlabel "dt (s)"
set ylabel "max |u - u_{limit}| (m)"
set xrange [6e-4:1.6e-2]
set yrange [5e-4:3e-2]
set xtics (0.001, 0.002, 0.005, 0.01)
plot C_max * x ls 8 title sprintf("%.3f dt, expected slope 1", C_max), \
     data index "orders_time" using "dt":"error" with linespoints ls 1 \
         title sprintf("error at t = 0.05 s, order %.2f", T_max)
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
unset multiplot
