# kink.gp - errors of the solution against element length: a smooth problem, a
# point load inside an element, a jump of beta inside one.
# Expected slopes: 2, 1.5, 1 in L2; 1, 0.5 in energy.
#
# Reads   data  tables solution, point_load, jump (and _orders)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,500
set output out
set style line 5 lc rgb "#E69F00" lw 2 pt 11 ps 0.7  # computed, fifth

set logscale xy
set xrange [5.5e-3:0.36]
set format y "10^{%T}"
set xtics ("1/128" 1./128, "1/64" 1./64, "1/32" 1./32, "1/16" 1./16, \
           "1/8" 1./8, "1/4" 1./4)
set xlabel "element length h"
set key above left vertical maxrows 5 reverse Left samplen 2 font ",12"

# The one number of a column of the table NAME_orders.
order(table, name) = system(sprintf( \
    "awk -F'\t' -v t='# %s_orders' -v c='%s' \
     '$0 == t { on = 1; next } on == 1 { for (i = 1; i <= NF; i++) \
      if ($i == c) k = i; on = 2; next } on == 2 { print $k; exit }' '%s'", \
    table, name, data)) + 0.0
say(text, table, name) = sprintf("%s: order %.2f", text, order(table, name))

set multiplot layout 1,2 margins 0.085,0.985,0.115,0.77 spacing 0.1,0

set ylabel "L^2 norm of the error"
set yrange [1e-6:1]
set label 1 "slope 1" at 0.0062, 6e-3 font ",12"
set label 2 "1.5" at 0.0062, 2.6e-4 font ",12"
set label 3 "2" at 0.0066, 4e-6 font ",12"

plot data index "jump" using "h":"L2_sampled" with linespoints ls 2 \
         title say("β jumps, sampled", "jump", "L2_sampled"), \
     data index "jump" using "h":"L2_exact" with linespoints ls 4 \
         title say("β jumps, integrated exactly", "jump", \
                   "L2_exact"), \
     data index "jump" using "h":"L2_harmonic" with linespoints ls 3 \
         title say("β jumps, harmonic mean", "jump", \
                   "L2_harmonic"), \
     data index "point_load" using "h":"L2" with linespoints ls 5 \
         title say("point load", "point_load", "L2"), \
     data index "solution" using "h":"L2_midpoint" with linespoints ls 1 \
         title say("all smooth", "solution", "L2_midpoint"), \
     0.34 * x ls 8 notitle, 0.24 * x**1.5 ls 8 notitle, \
     0.22 * x**2 ls 8 notitle

unset label
set ylabel "energy norm of the error"
set yrange [3e-3:3]
set label 1 "slope 0.5" at 0.0062, 0.125 font ",12"
set label 2 "1" at 0.0072, 4.3e-3 font ",12"
plot data index "jump" using "h":"energy_sampled" with linespoints ls 2 \
         title say("β jumps, sampled", "jump", "energy_sampled"), \
     data index "jump" using "h":"energy_exact" with linespoints ls 4 \
         title say("β jumps, integrated exactly", "jump", \
                   "energy_exact"), \
     data index "jump" using "h":"energy_harmonic" with linespoints ls 3 \
         title say("β jumps, harmonic mean", "jump", \
                   "energy_harmonic"), \
     data index "point_load" using "h":"energy" with linespoints ls 5 \
         title say("point load", "point_load", "energy"), \
     data index "solution" using "h":"energy_midpoint" with linespoints ls 1 \
         title say("all smooth", "solution", "energy_midpoint"), \
     0.9 * x**0.5 ls 8 notitle, 0.8 * x ls 8 notitle
unset multiplot
