# hats.gp - one element's share of the hats and of A.
#
# Left: the hat functions on a small unequal grid, one element's two halves in
# colour.  Right: the pattern of A; each element adds a square of four entries,
# and neighbouring squares overlap in one diagonal entry.
# Reads   data  tables K_local (e x0 x1 K00 ..), nodes (x)
# Writes  out   SVG

load "figures/style.gp"
set terminal svg size 740,400 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3

mark = 2                       # the element in colour, the third: number j
                               # joins nodes j - 1 and j, and `e` is j - 1
stats data index "K_local" using "e" nooutput
last = int(STATS_max)                      # elements 0..last, nodes 0..last+1
stats data index "K_local" using (column("e") == mark ? column("x0") : 1/0) \
    name "x0" nooutput
stats data index "K_local" using (column("e") == mark ? column("x1") : 1/0) \
    name "x1" nooutput

set multiplot layout 1,2
set lmargin 10; set rmargin 2; set tmargin 1.5; set bmargin 4
set style fill transparent solid 0.25 noborder
set xlabel "x (dimensionless)"
set ylabel "hat functions (dimensionless)"
set xrange [-0.03:1.03]
set yrange [0:1.2]
set ytics 0.25
unset key
is(e) = column("e") == e
set label 1 sprintf("element %d", mark + 1) at 0.5 * (x0_min + x1_min), 1.16 \
    center boxed
# the local numbers of the two halves
set label 2 "0" at x0_min + 0.045, 0.93 left front tc ls 1
set label 3 "1" at x1_min - 0.045, 0.93 right front tc ls 2
plot data index "K_local" using "x0":(0):(column("x1")-column("x0")):(1) \
         with vectors nohead lw 1.5 lc rgb "#999999", \
     "" index "K_local" using "x0":(1):(column("x1")-column("x0")):(-1) \
         with vectors nohead lw 1.5 lc rgb "#999999", \
     "" index "K_local" \
         using (0.5*(column("x0")+column("x1"))):(is(mark) ? 0.5 : 1/0): \
               "x0":"x1":(0):(1) with boxxyerror lc rgb "#E69F00", \
     "" index "K_local" using "x0":(is(mark) ? 1 : 1/0): \
               (column("x1")-column("x0")):(-1) \
         with vectors nohead ls 1 lw 3, \
     "" index "K_local" using "x0":(is(mark) ? 0 : 1/0): \
               (column("x1")-column("x0")):(1) \
         with vectors nohead ls 2 lw 3 dt 2, \
     "" index "nodes" using "x":(0):0 with points pt 7 ps 0.6 \
         lc rgb "black", \
     "" index "nodes" using "x":(1.06):(sprintf("e_%d", column(0))) \
         with labels boxed

unset label 2
unset label 3
set label 1 sprintf("element %d", mark + 1) at mark + 1.6, mark - 0.3 left
set xlabel "column j"
set ylabel "row i"
set xrange [-0.6:last + 1.6]
set yrange [last + 1.6:-0.6]
set xtics 1
set ytics 1
set size ratio 1
unset grid
set style fill transparent solid 0.30 border lc rgb "#666666"
inside(i, j) = i >= mark && i <= mark + 1 && j >= mark && j <= mark + 1
plot data index "K_local" using "e":"e":(column("e")-0.46):(column("e")+1.46): \
         (column("e")-0.46):(column("e")+1.46) with boxxyerror \
         lc rgb "#999999", \
     "" index "K_local" using "e":(is(mark) ? mark : 1/0): \
         (mark-0.46):(mark+1.46):(mark-0.46):(mark+1.46) with boxxyerror \
         lc rgb "#E69F00" fs transparent solid 0.35 border lc rgb "#E69F00", \
     "" index "A" using "j":(column("value") != 0 && \
         !inside(column("i"), column("j")) ? column("i") : 1/0) \
         with points pt 7 ps 0.4 lc rgb "black", \
     "" index "K_local" using "e":(is(mark) ? mark : 1/0):("K_{00}") \
         with labels, \
     "" index "K_local" using (mark + 1):(is(mark) ? mark : 1/0):("K_{01}") \
         with labels, \
     "" index "K_local" using (mark):(is(mark) ? mark + 1 : 1/0):("K_{10}") \
         with labels, \
     "" index "K_local" using (mark + 1):(is(mark) ? mark + 1 : 1/0): \
         ("K_{11}") \
         with labels
unset multiplot
set output
