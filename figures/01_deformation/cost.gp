# cost.gp - the error of a bent strip's strain against the operations that it
# takes: the linear strain stops at the error that it has on the arc itself.
# Reads   data  table cost
# Writes  out   SVG
load "figures/style.gp"
set output out
set logscale xy
set xrange [400:3e6]
set yrange [0.015:4]
set format x "10^{%T}"
set format y "%g"
set xlabel "operations for all strains of the mesh"
set ylabel "error of the strain, relative to it"
of(lean, strain, y) = \
    column("lean") == lean && strcol("strain") eq strain ? column(y) : 1/0
set key above left maxrows 3 samplen 2
array Floor[2]
do for [k = 1:2] {
    lean = k == 1 ? 45 : 5
    stats data index "cost" using (column("n") == 64 ? \
        of(lean, "linear", "floor") : 1/0) nooutput name "S"
    Floor[k] = S_max
}
plot data index "cost" using "operations":(of(45, "linear", "error")) \
         with linespoints ls 2 title "linear strain, ends lean by 45°", \
     "" index "cost" using "operations":(of(5, "linear", "error")) \
         with linespoints ls 5 title "linear strain, by 5°", \
     "" index "cost" using "operations":(of(45, "green", "error")) \
         with linespoints ls 1 title "Green strain, by either", \
     Floor[1] with lines ls 8 title "what the linear strain of the arc is off by", \
     Floor[2] with lines ls 8 notitle
