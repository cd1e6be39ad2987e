# trap.gp - nodal errors that are the quadrature's, or nothing.
#
# Reads   data  table trap (nodal errors but for L2, with their orders)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,450 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3

# orders at n = 32, where order 4 is still far from round-off
at32(name) = sprintf("stats data index 'trap' every ::3::3 using (p_%s = \
column('%s_order')) nooutput", name, name)
eval at32("midpoint")
eval at32("gauss2")
eval at32("L2")
eval at32("exercise")
eval at32("fitted_L2")

set multiplot
unset key
set logscale xy
set xrange [1.0/760:1.0/2.6]
set yrange [2e-14:0.1]
set format y "10^{%T}"
set ytics 1e-14, 100
unset mytics
set xtics ("1/512" 1.0/512, "1/128" 1.0/128, "1/32" 1.0/32, "1/8" 1.0/8)
set xlabel "element length h" offset 0,0.3
set tmargin at screen 0.89
set bmargin at screen 0.155
h(n) = 1.0 / n
# what is below 1e-13 is drawn there: its digits mean nothing
shown(e) = e < 1e-13 ? 1e-13 : e

set label 3 "nodes, exact load:\nround-off (smaller ones\nare drawn at 10^{-13})" \
    at 1.0/3, 6e-11 right tc ls 3 boxed

set lmargin at screen 0.125
set rmargin at screen 0.525
set ylabel "error (dimensionless)" offset 1.5,0
set title "companion, β = 1"
set label 1 sprintf("L², exact load: order %.2f", p_L2) at 1.0/3, 2.5e-2 right tc ls 1 boxed
set label 2 sprintf("nodes, midpoint\nload: order %.2f", p_midpoint) \
    at 1.0/600, 9e-4 tc ls 2 boxed
set label 4 sprintf("nodes, Gauss\nload: order %.2f", p_gauss2) \
    at 1.0/600, 2e-8 tc ls 4 boxed
plot sqrt(7.0/2880) * x**2 with lines ls 8, \
     47.0/11520 * x**4 with lines ls 8, \
     data index "trap" using (h(column("n"))):"L2" with points ls 1 \
         pt 6 ps 1.9, \
     data index "trap" using (h(column("n"))):"midpoint" with points ls 2 \
         pt 4 ps 1.0, \
     data index "trap" using (h(column("n"))):"gauss2" with points ls 4 \
         ps 1.1, \
     data index "trap" using (h(column("n"))):(shown(column("exact"))) with points ls 3 \
         ps 1.1

set lmargin at screen 0.56
set rmargin at screen 0.985
unset ylabel
set format y ""
set title "exercise, β = 1 + x"
unset label 4
set label 1 sprintf("L², fitted: order %.2f", p_fitted_L2) at 1.0/3, 2.5e-2 right tc ls 1 boxed
set label 2 sprintf("nodes, exact\nload: order %.2f", p_exercise) \
    at 1.0/600, 9e-4 tc ls 2 boxed
set label 3 "nodes, fitted:\nround-off (smaller ones\nare drawn at 10^{-13})"
plot data index "trap" using (h(column("n"))):"fitted_L2" with points ls 1 \
         pt 6 ps 1.9, \
     data index "trap" using (h(column("n"))):"exercise" with points ls 2 \
         pt 4 ps 1.0, \
     data index "trap" using (h(column("n"))):(shown(column("fitted"))) with points ls 3 \
         ps 1.1, \
     sqrt(31.0/28800) * x**2 with lines ls 8
unset multiplot
set output
