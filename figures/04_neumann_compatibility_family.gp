# 04_neumann_compatibility_family.gp - one system, a whole family of solutions.
#
# Reads data (table family: x, below, minimum_norm, above, exact), writes out.

load "figures/style.gp"
set output out

set xlabel "position x (-)"
set ylabel "u (-)"
set yrange [-0.85:0.65]
set xrange [-0.02:1.02]

plot data index "family" using "x":"above" with linespoints ls 2 \
         title "another solution, c = +0.3", \
     "" index "family" using "x":"minimum_norm" with linespoints ls 1 lw 4 \
         ps 1 title "minimum norm, c = 0", \
     "" index "family" using "x":"below" with linespoints ls 3 \
         title "another solution, c = -0.3", \
     "" index "family" using "x":"exact" with lines ls 8 lw 1.5 \
         title "x - e^x, shifted to nodal mean 0", \
     0 with lines ls 9 notitle
set output
