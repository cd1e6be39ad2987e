# cost.gp - the error of a bent strip's strain against the operations that it
# takes: the linear strain stops at the error that it has on the arc itself.
# Reads   data  table cost
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 640,420 enhanced font "Helvetica,14"
set output out
set logscale xy
set xrange [400:3e6]
set yrange [0.015:4]
set format x "10^{%T}"
set format y "%g"
set xlabel "operations for all strains of the mesh"
set ylabel "relative error of the strain"
of(lean, strain, y) = \
    column("lean") == lean && strcol("strain") eq strain ? column(y) : 1/0
unset key
array Floor[2]
do for [k = 1:2] {
    lean = k == 1 ? 45 : 5
    stats data index "cost" using (column("n") == 64 ? \
        of(lean, "linear", "floor") : 1/0) nooutput name "S"
    Floor[k] = S_max
}
set label 1 "linear strain, ends lean by 45°" at 1.2e6,Floor[1]*1.25 right \
    textcolor rgb "#D55E00" boxed
set label 2 "linear strain, 5°" at 1.2e6,Floor[2]*1.25 right textcolor rgb "#E69F00" boxed
set label 3 "Green strain, 45° and 5° alike" at 5e4,0.055 right \
    textcolor rgb "#0072B2" boxed
set label 4 "dashed: limit of the linear strain" at 450,Floor[2]*0.82 boxed
plot data index "cost" using "operations":(of(45, "linear", "error")) \
         with linespoints ls 2, \
     "" index "cost" using "operations":(of(5, "linear", "error")) \
         with linespoints ls 5, \
     "" index "cost" using "operations":(of(45, "green", "error")) \
         with linespoints ls 1, \
     Floor[1] with lines ls 8, Floor[2] with lines ls 8
