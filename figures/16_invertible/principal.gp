# principal.gp - what five laws make of a triangle that is pushed flat and on:
# P^2 over s2, and P^2 in uniaxial strain near rest.
# Reads   data  tables principal, near_rest (law s1 s2 P1 P2 log)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,1000 enhanced font "Helvetica,19" \
    background rgb "white"
set output out

set multiplot
unset key
set tmargin at screen 0.985
set bmargin at screen 0.54
set lmargin at screen 0.155
set rmargin at screen 0.96
of(l) = stringcolumn("law") eq l ? column("s2") : NaN
P(l) = stringcolumn("law") eq l ? column("P2") / 1000 : NaN
log_P(l) = stringcolumn("law") eq l ? column("log") / 1000 : NaN
stats data index "principal" using "s1" nooutput
set xlabel sprintf("s_2  (with s_1 = %.4g, ε = 0.25)", STATS_max)
set ylabel "principal stress P̂_2  (kN/m^2)" offset 1
set xrange [-1:1.5]
set yrange [-35:5]
set object 1 rectangle from graph 0, graph 0 to first 0, graph 1 \
    fc rgb "#eeeeee" fs solid noborder behind
set label 1 "inside out" at -0.03, 3.2 right textcolor rgb "#555555"
set style textbox opaque noborder margins 0.4,0.4
set label 2 "log law" at 0.12, -26 left textcolor rgb "#0072B2" front boxed
set label 3 "stable" at -0.97, -1.4 left textcolor rgb "#B07800"
set label 4 "energy" at -0.97, -7.9 left textcolor rgb "#CC79A7"
set label 5 "cubic" at -0.50, -14.0 right textcolor rgb "#D55E00"
set label 6 "stress" at -0.58, -33.3 left rotate by 56 textcolor rgb "#009E73"
set label 7 "extended" at -0.28, -32.5 left rotate by 66 textcolor rgb "#2E86C1"
plot data index "principal" using (of("stress")):(P("stress")) \
         with lines ls 3, \
     "" index "principal" using (of("energy")):(P("energy")) \
         with lines ls 4, \
     "" index "principal" using (of("extended")):(P("extended")) \
         with lines ls 6, \
     "" index "principal" using (of("cubic")):(P("cubic")) \
         with lines ls 2, \
     "" index "principal" using (of("stable")):(P("stable")) \
         with lines ls 5, \
     "" index "principal" using (of("cubic")):(log_P("cubic")) \
         smooth mcsplines with lines ls 1
unset label
unset object
set label 3 "stable" at 1.17, 0.47 right textcolor rgb "#B07800" front boxed
set label 5 "log law, stress,\nenergy, extended" at 1.07, -0.03 left textcolor rgb "#0072B2" front boxed
set label 6 "cubic" at 0.592, -0.725 right textcolor rgb "#D55E00" front
set tmargin at screen 0.43
set bmargin at screen 0.085
set xrange [0.48:1.4]
set yrange [-0.95:0.6]
set xtics 0.2
set xlabel "s_2  (with s_1 = 1)"
set ylabel "P̂_2  (kN/m^2)" offset 1
plot data index "near_rest" using (of("extended")):(P("extended")) \
         with lines ls 6, \
     "" index "near_rest" using (of("cubic")):(P("cubic")) with lines ls 2, \
     "" index "near_rest" using (of("stable")):(P("stable")) \
         with lines ls 5, \
     "" index "near_rest" using (of("cubic")):(log_P("cubic")) \
         with lines ls 1
unset multiplot
set output
