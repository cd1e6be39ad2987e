# log_or_cubic.gp - how far the stresses of the cubic and of the linear law are
# from the log law's, in one dimension, nu = 0.3 (dots:
# 1 and 10 per cent), and the cubic one with 0.45 (dashed).
# Reads   data  tables difference, passes
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,430 enhanced font "Helvetica,17"
set output out
unset key
set xlabel "deformation gradient F (-)"
set xrange [0:3]
set xtics 0.5
set logscale y
set yrange [0.1:500]
set format y "%g"
set ytics (0.1, 1, 5, 10, 100)
set ylabel "error of P against the log law (%)"
set label 1 "linear" at 1.3, 150 left
set label 2 "cubic" at 2.15, 17 left textcolor ls 2
set label 3 "cubic, ν = 0.45" at 2.25, 300 right textcolor ls 2
notes(x) = column("nu") == 0.3 ? x : NaN
below(c) = column("F") < 1 ? abs(column(c)) : NaN # no line across F = 1
above(c) = column("F") > 1 ? abs(column(c)) : NaN
plot data index "difference" using "F":(below("cubic")) with lines ls 2, \
     "" index "difference" using "F":(below("linear")) with lines ls 8 lw 1.5, \
     "" index "difference" using "F":(above("cubic")) with lines ls 2, \
     "" index "difference" using "F":(above("linear")) with lines ls 8 lw 1.5, \
     "" index "difference" using "F":(below("tissue")) with lines ls 2 dt 2, \
     "" index "difference" using "F":(above("tissue")) with lines ls 2 dt 2, \
     "" index "passes" using (notes(column("cubic_tension"))):"percent" \
         with points pt 7 ps 0.8 lc rgb "#D55E00", \
     "" index "passes" using (notes(column("cubic_compression"))):"percent" \
         with points pt 7 ps 0.8 lc rgb "#D55E00"
