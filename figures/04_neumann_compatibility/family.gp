# family.gp - one system, a whole family of solutions.
#
# Reads   data  table family (x below minimum_norm above exact)
# Writes  out   SVG
load "figures/style.gp"
set output out
set key maxrows 5

# the constant of the exact solution x - e^x + C with nodal mean 0
stats data index "family" using (column("exact") - column("x") + \
    exp(column("x"))) name "C" nooutput

set xlabel "position x (-)"
set ylabel "u (-)"
set xrange [0:1]
set yrange [-0.9:0.7]
unset grid
set xzeroaxis ls 9

plot for [k = -4:4] data index "family" \
         using "x":(column("minimum_norm") + 0.1 * k) with lines ls 9 lw 1 \
         title (k == -4 ? "members of the family, c = -0.4, -0.3, ..., 0.4" : ""), \
     data index "family" using "x":"above" with linespoints ls 2 \
         title "c = +0.3", \
     "" index "family" using "x":"below" with linespoints ls 3 \
         title "c = -0.3", \
     "" index "family" using "x":"minimum_norm" with linespoints ls 1 lw 4 \
         ps 1 title "c = 0: minimum norm, the nodal values add up to 0", \
     x - exp(x) + C_mean with lines ls 8 lw 1.5 \
         title "exact, x - e^x + C with the same nodal mean"
set output
