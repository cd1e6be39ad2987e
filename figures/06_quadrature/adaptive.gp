# adaptive.gp - what int |x - 1/3| dx costs: error against the number of
# evaluations of the integrand.
#
# Reads   data  tables load_kink (n midpoint gauss2), adaptive (evaluations
#               error evaluations_split error_split)
# Writes  out   SVG
load "figures/style.gp"
set output out
set logscale xy
set format y "10^{%T}"
set xlabel "evaluations of the integrand"
set ylabel "|error| of the integral"
set xrange [3:1000]
set yrange [1e-14:1]
set key above left vertical maxrows 4
plot data index "load_kink" using "n":(abs(column("midpoint"))) \
         with linespoints ls 1 title "midpoint, n equal elements", \
     data index "load_kink" using (2 * column("n")):(abs(column("gauss2"))) \
         with linespoints ls 3 title "Gauss, n equal elements", \
     data index "adaptive" using "evaluations":"error" \
         with linespoints ls 2 title "qag: finds the kink by halving", \
     data index "adaptive" every ::0::0 \
         using "evaluations_split":"error_split" \
         with points ls 4 ps 1.2 title "qagp: is told where the kink is"
