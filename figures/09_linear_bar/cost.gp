# cost.gp - accuracy against cost: the error of the free end of a hanging or
# standing bar after k linear solves, against the log law.  The first solve is
# the linear bar.
# Reads   data  tables newton, cost
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,420 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
set logscale y
set xrange [0.6:5.9]
set yrange [1e-16:10]
set format y "10^{%T}"
set ytics 1e-15,1e3
set xtics 1
set xlabel "linear solves"
set ylabel "relative error of u(L)"
unset key
load_of(l) = system(sprintf( \
    "awk -F'\t' '$0 == \"# cost\" { on = 1; next } on && NF > 1 \
     { if (on++ == %d + 1) { print $1; exit } }' '%s'", l, data)) + 0.0
set label 1 "linear bar" at 1.24, 4 left
# the size of the force behind the lower end of its curve
do for [l = 1:3] {
    set label 3 + l sprintf("%g N/m³", load_of(l)) at l + 2.12, 3e-16 left \
        tc ls l
}
set label 7 "standing" at 4.12, 2e-7 left tc ls 3
set label 8 "hanging" at 3.86, 2.5e-10 right tc ls 3
set arrow 1 from 0.6, 0.01 to 5.9, 0.01 nohead ls 8
set label 3 "1 %" at 5.85, 0.035 right
set label 2 "round-off" at 0.68, 1.2e-14 left tc rgb "#555555"
set object 1 rectangle from 0.6, 1e-16 to 5.9, 1e-13 behind \
    fc rgb "#DDDDDD" fs solid 0.5 noborder
set object 2 rectangle from 0.8, 1e-13 to 1.2, 10 behind \
    fc rgb "#F0E442" fs transparent solid 0.30 noborder
# a curve ends where only round-off is left; of that there is no more to see
# than that it is there
shown(c) = (before = column(0) == 0 ? 1 : now, now = column(c), \
    before < 1e-13 ? NaN : now < 1e-13 ? 1.5e-15 : now)
# colours by the size of the force; a bar that stands is dashed and hollow
array Hollow[2] = [4, 8]
plot for [l = 1:3] data index "newton" \
         using (column("solves")):(shown(l + 1)) \
         with linespoints ls l ps 0.9, \
     for [l = 4:5] data index "newton" \
         using (column("solves")):(shown(l + 1)) with linespoints ls l - 2 \
         dt 2 pt Hollow[l - 3] ps 1.3
set output
