# cost.gp - conjugate gradients with the old diagonal entry and with 1: the largest
# error after each iteration; and the error that the residual accepts, against a factor
# that beta and f have in common.
# Reads   data  tables path, units
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,400 enhanced font "Helvetica,14"
set output out
of(start, y) = strcol("start") eq start ? column(y) : 1/0
set multiplot layout 1,2
set lmargin 9; set rmargin 2; set tmargin 2; set bmargin 4
unset key
set yrange [-0.03:1.05]

set xrange [0:70]
set xlabel "iterations, 64 elements"
set ylabel "largest error of u, relative"
set arrow 1 from 64, graph 0 to 64, graph 1 nohead ls 8
set label 1 "64 free nodes" at 63, 0.08 right
set label 2 "1 on the diagonal:\nu_0  comes last" at 62, 0.75 right textcolor ls 2
set label 3 "the old entry, or 1\nand a start with u_0  = g" at 62, 0.45 right \
    textcolor ls 1
# past the last iteration drawn the error is round-off
drop(start) = strcol("start") eq start ? \
    (strcol("error") eq "-" ? 0 : column("error")) : 1/0
plot data index "path" using "iteration":(drop("one")) with lines ls 2 lw 4, \
     "" index "path" using "iteration":(drop("one_from_g")) with lines ls 5, \
     "" index "path" using "iteration":(drop("kept")) with lines ls 1 dt 2

unset arrow 1
unset label 1
set label 2 "1 on\nthe diagonal" at 90, 0.9 left
set label 3 "the old entry,\nor 1 and a start\nwith u_0  = g" at 1e-4, 0.27 left
set logscale x
set format x "10^{%T}"
set xrange [5e-5:2e6]
set xlabel "factor of β and f"
set ylabel "largest error of u when it is accepted"
plot data index "units" using "scale":(of("one", "error")) with linespoints ls 2, \
     "" index "units" using "scale":(of("one_from_g", "error")) \
         with linespoints ls 5 ps 1.2, \
     "" index "units" using "scale":(of("kept", "error")) \
         with linespoints ls 1
unset multiplot
