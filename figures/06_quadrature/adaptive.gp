# adaptive.gp - what int |x - 1/3| dx costs: error against the number of
# evaluations of the integrand.
#
# Reads   data  tables load_kink (n midpoint gauss2), adaptive (evaluations
#               error evaluations_split error_split)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,400
set output out
set logscale xy
set format y "10^{%T}"
set xlabel "evaluations of the integrand"
set ylabel "|error| of the integral"
set xrange [3:1000]
set yrange [1e-14:1]
unset key
set label 1 "midpoint, n equal elements" at 20, 3e-3 tc ls 1
set label 2 "Gauss, n equal elements" at 6, 8e-6 tc ls 3
set label 3 "qag: finds the\nkink by halving" at 200, 1e-10 right tc ls 2
set label 4 "qagp: is told\nwhere the kink is" at 36, 1.6e-13 right tc ls 4
plot data index "load_kink" using "n":(abs(column("midpoint"))) \
         with linespoints ls 1, \
     data index "load_kink" using (2 * column("n")):(abs(column("gauss2"))) \
         with linespoints ls 3, \
     data index "adaptive" using "evaluations":"error" \
         with linespoints ls 2, \
     data index "adaptive" every ::0::0 \
         using "evaluations_split":"error_split" \
         with points ls 4 ps 1.2
