# order_in_time.gp - order one in time, with the measured order.
# Reads   data  table orders_time
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,440
set output out
stats data index "orders_time" using "order" nooutput name "T"
stats data index "orders_time" using "constant" nooutput name "C"
set margins screen 0.137, screen 0.976, screen 0.13, screen 0.87
set key above left maxrows 4 samplen 2
set logscale xy
set format y "10^{%T}"
set xlabel "Δt (s)"
set ylabel "max |u - u_{limit}| (m)"
set xrange [6e-4:1.6e-2]
set yrange [5e-4:3e-2]
set xtics (0.001, 0.002, 0.005, 0.01)
set datafile missing "-"
plot C_max * x ls 8 title sprintf("%.3f Δt, expected slope 1", C_max), \
     data index "orders_time" using "dt":"error" with linespoints ls 1 \
         title sprintf("error at t = 0.05 s, order %.2f", T_max)
