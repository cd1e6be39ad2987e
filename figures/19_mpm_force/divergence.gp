# divergence.gp - the divergence of P with respect to X, which is J times the
# divergence of the Cauchy stress, and with respect to x, as printed; at every
# second point.
# Reads   data  tables square, point
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,640 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
set size ratio -1
set xrange [-0.3:1.4]
set yrange [-0.2:1.5]
set xtics 0.5
set ytics 0.5
set xlabel "x (m)"
set ylabel "y (m)"
unset key
set label 1 "divergence of P with respect\nto x, as printed" at 0.06, 1.43 tc ls 2
set label 2 "divergence of P\nwith respect to X" at 0.56, 0.14 tc ls 1
set label 3 "dashed: J times that of σ\nwith respect to x" at 0.56, -0.07
k = 0.0004
set label 4 "500 N/m³" at -0.27, 1.34
set arrow 1 from -0.27, 1.43 to -0.27 + 500 * k, 1.43 head filled size 0.022,20 lw 1.5
plot data index "square" every 2 using "x":"y":(k*column("div_x_1")):(k*column("div_x_2")) \
         with vectors head filled size 0.022,20 ls 2, \
     data index "square" every 2 using "x":"y":(k*column("Div_X_1")):(k*column("Div_X_2")) \
         with vectors head filled size 0.022,20 ls 1 lw 3, \
     data index "square" every 2 using "x":"y":(k*column("J_div_1")):(k*column("J_div_2")) \
         with vectors nohead ls 8 lw 1.5, \
     data index "square" every 2 using "x":"y" with points ls 9 lc rgb "black" pt 7 \
         ps 0.4
