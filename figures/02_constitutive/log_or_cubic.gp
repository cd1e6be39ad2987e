# log_or_cubic.gp - the stress of Figure 6 of the notes in one dimension, and how
# far the stresses of the cubic and the linear law are from that of the log law.
# Reads   data  tables curve_log, curve_cubic, curve_linear, difference, passes
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 800,430 enhanced font "Helvetica,17"
set output out
unset key
set multiplot layout 1,2
set lmargin 9.5; set rmargin 2; set tmargin 2; set bmargin 3.6
set xlabel "deformation gradient F (-)"

# ---- stress
set xrange [-1:3]
set xtics 1
set ylabel "stress P (N/m^2)" offset 0.5
set yrange [-9000:5000]
set ytics 2000
set object 1 rectangle from graph 0, graph 0 to first 0, graph 1 \
    fc rgb "#eeeeee" fs solid noborder behind
set label 1 "inside\nout" at -0.95, 4400 textcolor rgb "#555555"
set label 2 "log: only F > 0" at 0.35, -7600 left textcolor ls 1 boxed
set label 3 "cubic" at -0.25, -6500 right textcolor ls 2
set label 4 "linear" at -0.95, -1150
set label 5 "P(0) =\n-(11λ/2 + 3μ)" at 0.62, -4300 left boxed
set arrow 5 from 0.6, -4300 to 0.06, -4320 nohead ls 9 lw 1
plot data index "curve_log" using "F":"P" with lines ls 1, \
     "" index "curve_cubic" using "F":"P" with lines ls 2, \
     "" index "curve_linear" using "F":"P" with lines ls 8 lw 1.5, \
     "" index "curve_cubic" using "F":(column("F") == 0 ? column("P") : NaN) \
         with points pt 7 ps 0.8 lc rgb "#D55E00", \
     0 with lines ls 9

# ---- the difference, in per cent, on a logarithmic scale
unset object 1
unset arrow 5
unset label
set xrange [0:3]
set xtics 0.5
set logscale y
set yrange [0.1:500]
set format y "%g"
set ytics (0.1, 1, 5, 10, 100)
set ylabel "error of P against the log law (%)"
set label 1 "linear" at 1.3, 150 left boxed
set label 2 "cubic" at 2.15, 17 left textcolor ls 2 boxed
below(c) = column("F") < 1 ? abs(column(c)) : NaN # no line across F = 1
above(c) = column("F") > 1 ? abs(column(c)) : NaN
plot data index "difference" using "F":(below("cubic")) with lines ls 2, \
     "" index "difference" using "F":(below("linear")) with lines ls 8 lw 1.5, \
     "" index "difference" using "F":(above("cubic")) with lines ls 2, \
     "" index "difference" using "F":(above("linear")) with lines ls 8 lw 1.5, \
     "" index "passes" using "cubic_tension":"percent" \
         with points pt 7 ps 0.8 lc rgb "#D55E00", \
     "" index "passes" using "cubic_compression":"percent" \
         with points pt 7 ps 0.8 lc rgb "#D55E00"
unset multiplot
