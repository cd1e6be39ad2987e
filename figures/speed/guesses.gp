# guesses.gp - linear systems per step by where it starts, with
# new factors each time (above) and with kept ones [alg:chord] (below).
# Reads   data  tables newton_last, newton_velocity, newton_velocity_lift,
#               newton_extrapolated_lift (n full_mean full_max chord_mean
#               chord_max); from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,780
set output out
array Table[4] = ["newton_last", "newton_velocity", "newton_velocity_lift", \
                  "newton_extrapolated_lift"]
array Name[4] = ["u_0", "u_0 + Δt v_0", "the same, lifted", "parabola, lifted"]
array Style[4] = [2, 4, 3, 1]

set multiplot layout 2,1 margins 0.11,0.74,0.075,0.985 spacing 0,0.10
unset key
set logscale x
set xtics (8, 16, 32, 64, 96)
set xrange [7:112]
set yrange [0:11.5]
set xlabel "squares per side n"
set ylabel "systems per step: new factors"
array First[4] = [5, 3.75, 3.05, 2.3]
do for [k = 1:4] {
    color = Style[k]
    set label k Name[k] at 120, First[k] tc ls color
}
plot for [k = 1:4] data index Table[k] using "n":"full_mean" \
         with linespoints ls Style[k]
array Height[4] = [8.7, 4.9, 3.4, 2.7]
do for [k = 1:4] {
    color = Style[k]
    set label k Name[k] at 120, Height[k] tc ls color
}
set label 5 "dotted:\nfactorisations,\nabout 1,\nbut not from u_0" at 120, 1.6
set ylabel "systems per step: factors kept"
plot for [k = 1:4] data index Table[k] using "n":"chord_mean" \
         with linespoints ls Style[k], \
     for [k = 1:4] data index Table[k] using "n":"chord_factorisations" \
         with lines ls Style[k] dt (1.5,2.5)
unset multiplot
