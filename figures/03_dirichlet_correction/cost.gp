# cost.gp - conjugate gradients with the old diagonal entry and with 1: the error
# after each iteration; and the error that the residual accepts, against a factor
# that beta and f have in common.
# Reads   data  tables path, units
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 820,440
set output out
of(start, y) = strcol("start") eq start ? column(y) : 1/0
set multiplot layout 1,2
set lmargin 9; set rmargin 2; set tmargin 5; set bmargin 4
set key above left maxrows 3 samplen 2

set xrange [0:70]
set yrange [0:22]
set xlabel "iterations, 64 elements"
set ylabel "error in the energy norm, relative"
set arrow 1 from 64, graph 0 to 64, graph 1 nohead ls 8
set label 1 "64 free nodes" at 63, 14 right
# past the last iteration drawn the error is round-off
drop(start, y) = strcol("start") eq start ? \
    (strcol("error") eq "-" ? 0 : column(y)) : 1/0
plot data index "path" using "iteration":(drop("one", "error")) with lines ls 2 \
         title "1 on the diagonal", \
     "" index "path" using "iteration":(drop("one_from_g", "error")) \
         with lines ls 5 title "1, and a start with u_0 = g", \
     "" index "path" using "iteration":(drop("kept", "error")) \
         with lines ls 1 dt 2 title "the old entry"

unset arrow 1
unset label 1
set logscale x
set format x "10^{%T}"
set xrange [5e-5:2e6]
set yrange [-0.03:1]
set xlabel "factor of β and f"
set ylabel "largest error of u when it is accepted, relative"
plot data index "units" using "scale":(of("one", "error")) with linespoints ls 2 \
         title "1 on the diagonal", \
     "" index "units" using "scale":(of("one_from_g", "error")) \
         with linespoints ls 5 ps 1.2 title "1, and a start with u_0 = g", \
     "" index "units" using "scale":(of("kept", "error")) \
         with linespoints ls 1 title "the old entry"
unset multiplot
