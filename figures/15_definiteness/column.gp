# column.gp - the pressed column after it has buckled, coloured by J.
# Reads   data  table nodes (X Y u_x u_y)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,270 enhanced font "Helvetica,16" background rgb "white"
set output out
table = "nodes"
load "figures/square.gp"
eval reach(1.05)
set yrange [-0.35:0.35]
set xtics 1
set ytics 0.2
set xlabel "x (m)"
set ylabel "y (m)"
set rmargin at screen 0.80
plot @SQUARE
