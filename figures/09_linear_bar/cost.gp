# cost.gp - accuracy against cost: the error of the free end of a hanging or
# standing bar after k linear solves, against the log law.  The first solve is
# the linear bar.
# Reads   data  tables newton, cost
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,440 enhanced font "Helvetica,13" \
    background rgb "white"
set output out
set logscale y
set xrange [0.6:5.6]
set yrange [1e-16:100]
set ytics ("10^{-15}" 1e-15, "10^{-12}" 1e-12, "10^{-9}" 1e-9, \
           "10^{-6}" 1e-6, "10^{-4}" 1e-4, "1 %%" 1e-2, "100 %%" 1)
set xtics 1
set xlabel "linear solves"
set ylabel "relative error of u(L)"
set key above left vertical maxrows 3 reverse Left
set label 1 "linear bar" at 1, 8 center
set arrow 1 from 0.6, 0.01 to 5.6, 0.01 nohead ls 8
set label 2 "round-off" at 5.55, 4e-16 right tc rgb "#555555"
set object 1 rectangle from 0.6, 1e-16 to 5.6, 1e-14 behind \
    fc rgb "#DDDDDD" fs solid 0.5 noborder
set object 2 rectangle from 0.8, 1e-16 to 1.2, 100 behind \
    fc rgb "#F0E442" fs transparent solid 0.30 noborder
load_of(l) = system(sprintf( \
    "awk -F'\t' '$0 == \"# cost\" { on = 1; next } on && NF > 1 \
     { if (on++ == %d + 1) { print $1; exit } }' '%s'", l, data)) + 0.0
# a curve ends where only round-off is left; of that there is no more to see
# than that it is there
shown(c) = (before = column(0) == 0 ? 1 : now, now = column(c), \
    before < 1e-14 ? NaN : now < 1e-14 ? 1.5e-15 : now)
plot for [l = 1:4] data index "newton" \
         using (column("solves")):(shown(l + 1)) \
         with linespoints ls l ps 0.9 \
         title sprintf("body force %+g N/m³", load_of(l)), \
     data index "newton" using (column("solves")):(shown(6)) \
         with linespoints lc rgb "#000000" lw 2 dt 4 pt 4 ps 0.9 \
         title sprintf("body force %+g N/m³", load_of(5))
set output
