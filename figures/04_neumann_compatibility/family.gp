# family.gp - one system, a whole family of solutions.
#
# Reads   data  table family (x below minimum_norm above exact)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,440 enhanced font "Helvetica,17"
set output out
unset key
set rmargin 18

# the constant of the exact solution x - e^x + C with nodal mean 0
stats data index "family" using (column("exact") - column("x") + \
    exp(column("x"))) name "C" nooutput

set xlabel "position x (-)"
set ylabel "u (-)"
set xrange [0:1]
set yrange [-0.9:0.85]
unset grid
set xzeroaxis ls 9
set label 1 "c = 0.3" at 1.035, -0.15 tc ls 2
set label 2 "c = 0: least norm;\nthe values add\nup to 0" at 1.035, -0.39 tc ls 1
set label 3 "c = -0.3" at 1.035, -0.8 tc ls 3
set label 4 "all: c = -0.4, -0.3, ..., 0.4" at 0.98, 0.79 right tc rgb "#777777"
set label 5 "dashed: exact" at 0.98, 0.66 right

plot for [k = -4:4] data index "family" \
         using "x":(column("minimum_norm") + 0.1 * k) with lines ls 9 lw 1, \
     data index "family" using "x":"above" with linespoints ls 2, \
     "" index "family" using "x":"below" with linespoints ls 3, \
     "" index "family" using "x":"minimum_norm" with linespoints ls 1 lw 4 ps 1, \
     x - exp(x) + C_mean with lines ls 8 lw 1.5
set output
