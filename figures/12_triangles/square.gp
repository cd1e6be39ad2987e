# square.gp - the square at rest, coloured by J: the lesson's own numbers.
# Reads   data  table nodes (X Y u_x u_y)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,430
set output out
table = "nodes"
load "figures/square.gp"
eval reach(1.5)
set xlabel "x (m)"
set ylabel "y (m)"
set xtics 1
set ytics 1
plot @SQUARE
