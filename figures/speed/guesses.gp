# guesses.gp - linear systems per step by where it starts, with
# new factors each time (left) and with kept ones [alg:chord] (right).
# Reads   data  tables newton_last, newton_velocity, newton_velocity_lift,
#               newton_extrapolated_lift (n full_mean full_max chord_mean
#               chord_max); from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,440
set output out
array Table[4] = ["newton_last", "newton_velocity", "newton_velocity_lift", \
                  "newton_extrapolated_lift"]
array Name[4] = ["u_0", "u_0 + Δt v_0", "the same, lifted", \
                 "u_0 + Δt (2 v_0 - v_{before}), lifted"]
array Style[4] = [2, 4, 3, 1]

set multiplot layout 1,2 margins 0.065,0.985,0.135,0.77 spacing 0.075,0
set key above left vertical maxrows 4 reverse Left samplen 2 font ",12"
set logscale x
set xtics (8, 16, 32, 64, 96)
set xrange [7:112]
set yrange [0:11.5]
set xlabel "squares per side n"
set ylabel "linear systems per step (mean), new factors"
plot for [k = 1:4] data index Table[k] using "n":"full_mean" \
         with linespoints ls Style[k] title "guess ".Name[k]
set ylabel "linear systems per step (mean), factors kept"
plot for [k = 1:4] data index Table[k] using "n":"chord_mean" \
         with linespoints ls Style[k] notitle, \
     for [k = 1:4] data index Table[k] using "n":"chord_factorisations" \
         with lines ls Style[k] lw 1 dt 3 notitle, \
     1/0 with lines ls 8 lw 1 dt 3 title "of them with new factors"
unset multiplot
