# adaptive.gp - what samples buy: the error of a solution, and that of
# int |x - 1/3| dx, against the number of samples.
#
# Reads   data  tables solution (n and the rules), load_kink (n midpoint gauss2),
#               adaptive (evaluations error evaluations_split error_split)
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 800,450 enhanced font "Helvetica,17"
set output out
set logscale xy
set format y "10^{%T}"
unset key
set multiplot layout 1,2 margins 0.125,0.97,0.175,0.91 spacing 0.14,0

set title "smooth problem" offset 0,-0.5
set xlabel "samples of β and of f, each"
set ylabel "L^2 error of the solution"
set yrange [1e-6:0.1]
set xrange [3:3500]
set label 1 "midpoint" at 22, 4e-4 right textcolor ls 1 boxed
set label 2 "trapezoidal" at 6, 4.8e-2 left textcolor ls 2 boxed
set label 3 "Gauss" at 580, 3e-6 left textcolor ls 3 boxed
plot data index "solution" using "n":"midpoint" with linespoints ls 1, \
     data index "solution" using (column("n") + 1):"trapezoid" \
         with linespoints ls 2, \
     data index "solution" using (2 * column("n")):"gauss2" with linespoints ls 3

set title "integral of |x - 1/3|" offset 0,-0.5
set xlabel "evaluations of the integrand"
set ylabel "|error| of the integral"
set yrange [1e-14:1]
set xrange [3:1000]
set label 1 "midpoint" at 20, 3e-3 left textcolor ls 1 boxed
set label 2 "qag: finds the\nkink by halving" at 210, 6e-9 right textcolor rgb "black" boxed
set label 3 "Gauss" at 14, 8e-6 right textcolor ls 3 boxed
set label 4 "qagp: is told\nwhere the kink is" at 42, 1.2e-11 center textcolor rgb "black" boxed
plot data index "load_kink" using "n":(abs(column("midpoint"))) \
         with linespoints ls 1, \
     data index "load_kink" using (2 * column("n")):(abs(column("gauss2"))) \
         with linespoints ls 3, \
     data index "adaptive" using "evaluations":"error" \
         with linespoints ls 8 lw 2 dt 1 pt 7 ps 0.6, \
     data index "adaptive" every ::0::0 \
         using "evaluations_split":"error_split" \
         with points ls 8 pt 13 ps 1.4
unset multiplot
