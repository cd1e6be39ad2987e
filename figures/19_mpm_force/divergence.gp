# divergence.gp - the divergence of P with respect to X, which is J times the
# divergence of the Cauchy stress, and with respect to x, as printed; at every
# second point.
# Reads   data  tables square, point
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,560
set output out
set size ratio -1
set xrange [-0.3:1.4]
set yrange [-0.2:1.5]
set xtics 0.5
set ytics 0.5
set xlabel "x (m)"
set ylabel "y (m)"
set key above left maxrows 2 samplen 2
k = 0.0004
plot data index "square" every 2 using "x":"y":(k*column("div_x_1")):(k*column("div_x_2")) \
         with vectors head filled size 0.022,20 ls 2 \
         title "with respect to x, as printed", \
     data index "square" every 2 using "x":"y":(k*column("Div_X_1")):(k*column("Div_X_2")) \
         with vectors head filled size 0.022,20 ls 1 lw 3 \
         title "of P with respect to X", \
     data index "square" every 2 using "x":"y":(k*column("J_div_1")):(k*column("J_div_2")) \
         with vectors nohead ls 8 lw 1.5 \
         title "J times that of σ with respect to x", \
     data index "square" every 2 using "x":"y" with points ls 9 lc rgb "black" pt 7 \
         ps 0.4 notitle
