# trap.gp - nodal errors that are the quadrature's, or nothing.
#
# Reads   data  table trap (nodal errors but for L2, with their orders)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,500 enhanced font "Helvetica,14" \
    background rgb "white"
set output out

# orders at n = 32, where order 4 is still far from round-off
at32(name) = sprintf("stats data index 'trap' every ::3::3 using (p_%s = \
column('%s_order')) nooutput", name, name)
eval at32("midpoint")
eval at32("gauss2")
eval at32("L2")
eval at32("exercise")
eval at32("fitted_L2")

set multiplot
set logscale xy
set xrange [1.0/760:1.0/2.6]
set yrange [3e-14:0.03]
set format y "10^{%T}"
set ytics 1e-14, 100
unset mytics
set xtics ("1/512" 1.0/512, "1/128" 1.0/128, "1/32" 1.0/32, "1/8" 1.0/8)
set xlabel "element length h (domain of length 1)"
set tmargin at screen 0.74
set bmargin at screen 0.12
h(n) = 1.0 / n
# what is below 1e-13 is drawn there: its digits mean nothing
shown(e) = e < 1e-13 ? 1e-13 : e

set label 3 "round-off, at most 10^{-13}" at 1.0/40, 8e-13 left textcolor rgb "#666666"

set lmargin at screen 0.095
set rmargin at screen 0.525
set ylabel "error (dimensionless)"
set label 1 "companion, β = 1" at screen 0.085, 0.965 font ",15"
set key at screen 0.07, 0.94 left top maxrows 4 reverse Left samplen 1.6 \
    spacing 1.15
plot sqrt(7.0/2880) * x**2 with lines ls 8 notitle, \
     47.0/11520 * x**4 with lines ls 8 notitle, \
     data index "trap" using (h(column("n"))):"L2" with points ls 1 ps 0.7 \
         title sprintf("L_2 error, exact load:  order %.2f", p_L2), \
     data index "trap" using (h(column("n"))):"midpoint" with points ls 2 \
         pt 4 ps 1.2 title sprintf("nodal, midpoint load:  order %.2f", \
                                   p_midpoint), \
     data index "trap" using (h(column("n"))):"gauss2" with points ls 4 \
         ps 1.1 title sprintf("nodal, Gauss load:  order %.2f", p_gauss2), \
     data index "trap" using (h(column("n"))):(shown(column("exact"))) with points ls 3 \
         ps 1.1 title "nodal, exact load:  no order"

set lmargin at screen 0.56
set rmargin at screen 0.985
unset ylabel
set format y ""
set label 1 "exercise, β = 1 + x" at screen 0.55, 0.965
set key at screen 0.535, 0.94
plot data index "trap" using (h(column("n"))):"fitted_L2" with points ls 1 \
         ps 0.7 title sprintf("L_2 error, fitted:  order %.2f", p_fitted_L2), \
     data index "trap" using (h(column("n"))):"exercise" with points ls 2 \
         pt 4 ps 1.2 title sprintf("nodal, exact load:  order %.2f", \
                                   p_exercise), \
     data index "trap" using (h(column("n"))):(shown(column("fitted"))) with points ls 3 \
         ps 1.1 title "nodal, fitted:  no order", \
     sqrt(31.0/28800) * x**2 with lines ls 8 title "theory: slopes 2 and 4"
unset multiplot
set output
