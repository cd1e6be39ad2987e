# samples.gp - what samples buy: the error of a solution against their number.
#
# Reads   data  table solution (n and the rules)
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 620,420 enhanced font "Helvetica,15"
set output out
set logscale xy
set format y "10^{%T}"
unset key
set xlabel "samples of β and of f, each"
set ylabel "L^2 error of the solution"
set yrange [1e-6:0.1]
set xrange [3:1000]
set label 1 "midpoint" at 22, 4e-4 right textcolor ls 1 boxed
set label 2 "trapezoidal" at 6, 4.8e-2 left textcolor ls 2 boxed
set label 3 "Gauss" at 580, 3e-6 left textcolor ls 3 boxed
plot data index "solution" using "n":"midpoint" with linespoints ls 1, \
     data index "solution" using (column("n") + 1):"trapezoid" \
         with linespoints ls 2, \
     data index "solution" using (2 * column("n")):"gauss2" with linespoints ls 3
