# orders.gp - three errors against h, on the lines that the
# theory predicts.
#
# Reads   data  table orders (n, three errors with their orders and constants)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 720,440 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3

# orders and constants of the finest pair of grids: the last row stays
finest(name) = sprintf("stats data index 'orders' using (p_%s = \
column('%s_order'), C_%s = column('%s_constant')) nooutput", \
    name, name, name, name)
eval finest("nodal")
eval finest("L2")
eval finest("energy")
entry(name, p, C) = sprintf("%s: order %.2f, constant %.4f", name, p, C)

set logscale xy
set xrange [1.0/760:1.0/2.6]
# a wrong program's errors may be larger than any here
stats data index "orders" using "energy" nooutput
set yrange [1.2e-8:(STATS_max > 0.05 ? 3 * STATS_max : 0.12)]
set format y "10^{%T}"
set xtics ("1/512" 1.0/512, "1/256" 1.0/256, "1/128" 1.0/128, "1/64" 1.0/64, \
           "1/32" 1.0/32, "1/16" 1.0/16, "1/8" 1.0/8, "1/4" 1.0/4)
unset mytics
set xlabel "element length h (domain of length 1)"
set ylabel "error (dimensionless)" offset 1
unset key

# the theory, extended beyond the data at both ends
energy(h) = sqrt(7.0) / 24.0 * h
L2(h) = 0.0317641 * h**2
nodal(h) = (1.0 / 144.0 + log(2.0) / 96.0) * h**2
set label 1 entry("energy norm", p_energy, C_energy) at 1.0/600, 1.5e-2 tc ls 1 boxed
set label 2 "theory: √7 h / 24" at 1.0/600, 6.5e-3 tc ls 1 boxed
set label 3 entry("L² norm", p_L2, C_L2) at 1.0/600, 6e-5 tc ls 2 boxed
set label 4 "theory: 0.0318 h²" at 1.0/600, 2.7e-5 tc ls 2 boxed
set label 5 entry("nodes", p_nodal, C_nodal) at 1.0/80, 6e-7 tc ls 3 boxed
set label 6 "theory: (1/144 + ln 2 / 96) h²" at 1.0/80, 2.7e-7 tc ls 3 boxed

plot energy(x) with lines ls 8, \
     L2(x) with lines ls 8, \
     nodal(x) with lines ls 8, \
     data index "orders" using (1 / column("n")):"energy" with points \
         ls 1 ps 1.0, \
     data index "orders" using (1 / column("n")):"L2" with points \
         ls 2 ps 0.9, \
     data index "orders" using (1 / column("n")):"nodal" with points \
         ls 3 ps 1.1
set output
