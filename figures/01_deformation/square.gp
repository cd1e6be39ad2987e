# square.gp - the square that is pushed inside, put together from F of its
# triangles and coloured by their J: the lesson's own numbers.
# Reads   data  table triangles (F11 F21 J)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,430
set output out
table = "triangles"
load "figures/square.gp"
eval reach(1.1)
said = system(ask(data, "said"))
all = system("awk '$0 == \"# triangles\" { on = 1; next } NF == 0 { on = 0 } \
    on { n++ } END { print n - 1 }' '".data."'")
if (said ne "") set title said."(".all." in all)"
set xtics 1
set ytics 1
set xlabel "x (m)"
set ylabel "y (m)"
plot @SQUARE
