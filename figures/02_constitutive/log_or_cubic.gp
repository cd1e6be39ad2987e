# log_or_cubic.gp - Figure 6 of the notes: r, energy and stress of the log and
# the cubic law in one dimension, and how far the stresses are apart.
# Reads   data  tables curve_log, curve_cubic, curve_linear, difference, passes
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,700
set output out

set multiplot
# ---- the key alone, over all four
set lmargin at screen 0.09
set rmargin at screen 0.98
set tmargin at screen 0.94
set bmargin at screen 0.93
set key above left horizontal maxrows 1 reverse Left samplen 4 width 4
unset border
unset tics
unset grid
set yrange [0:1]
plot [0:1] NaN with lines ls 1 lw 3 title "log (J > 0 only)", \
     NaN with lines ls 2 lw 3 title "cubic", \
     NaN with lines ls 8 lw 1.5 title "linear"
unset key
set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid back ls 9

set xrange [-1:3]
set xtics 1
set object 1 rectangle from graph 0, graph 0 to first 0, graph 1 \
    fc rgb "#eeeeee" fs solid noborder behind
set label 1 "inside out" at graph 0.02, graph 0.06 font ",12" \
    textcolor rgb "#555555"

# ---- r itself
set tmargin at screen 0.91
set bmargin at screen 0.575
set lmargin at screen 0.09
set rmargin at screen 0.48
set xlabel "J (-)"
set ylabel "r(J) (-)"
set yrange [-3.5:3]
set ytics 1
set label 1 at graph 0.02, graph 0.93
set label 2 "r(0) = -11/6" at -0.08, -1.55 right font ",12"
plot data index "curve_log" using "F":"r" with lines ls 1, \
     "" index "curve_cubic" using "F":"r" with lines ls 2, \
     "" index "curve_cubic" using "F":(column("F") == 0 ? column("r") : NaN) \
         with points pt 7 ps 0.8 lc rgb "#D55E00"

# ---- energy
set lmargin at screen 0.59
set rmargin at screen 0.98
set xlabel "deformation gradient F (-)"
set ylabel "energy ψ (J/m^3)" offset 0.5
set yrange [0:4000]
set ytics 1000
set label 1 at graph 0.02, graph 0.06
unset label 2
plot data index "curve_log" using "F":"psi" with lines ls 1, \
     "" index "curve_cubic" using "F":"psi" with lines ls 2, \
     "" index "curve_linear" using "F":"psi" with lines ls 8 lw 1.5

# ---- stress
set tmargin at screen 0.435
set bmargin at screen 0.09
set lmargin at screen 0.09
set rmargin at screen 0.48
set ylabel "stress P (N/m^2)" offset 0.5
set yrange [-9000:5000]
set ytics 2000
set label 1 at graph 0.02, graph 0.93
set label 2 "P(0) = -(11λ/2 + 3μ)" at 0.55, -5400 left offset 0,0 font ",12"
plot data index "curve_log" using "F":"P" with lines ls 1, \
     "" index "curve_cubic" using "F":"P" with lines ls 2, \
     "" index "curve_linear" using "F":"P" with lines ls 8 lw 1.5, \
     "" index "curve_cubic" using "F":(column("F") == 0 ? column("P") : NaN) \
         with points pt 7 ps 0.8 lc rgb "#D55E00", \
     0 with lines ls 9

# ---- the difference, in per cent, on a logarithmic scale
unset object 1
unset label
set lmargin at screen 0.59
set rmargin at screen 0.98
set xrange [0:3]
set xtics 0.5
set logscale y
set yrange [0.1:500]
set format y "%g"
set ytics (0.1, 1, 5, 10, 100)
set ylabel "error of P, log law's = 0 (%)"
below(c) = column("F") < 1 ? abs(column(c)) : NaN # no line across F = 1
above(c) = column("F") > 1 ? abs(column(c)) : NaN
plot data index "difference" using "F":(below("cubic")) with lines ls 2, \
     "" index "difference" using "F":(below("linear")) with lines ls 8 lw 1.5, \
     "" index "difference" using "F":(above("cubic")) with lines ls 2, \
     "" index "difference" using "F":(above("linear")) with lines ls 8 lw 1.5, \
     "" index "passes" using "cubic_tension":"percent" \
         with points pt 7 ps 0.8 lc rgb "#D55E00", \
     "" index "passes" using "cubic_compression":"percent" \
         with points pt 7 ps 0.8 lc rgb "#D55E00", \
     "" index "passes" using "cubic_tension":"percent":\
         (sprintf("%.3f", column("cubic_tension"))) \
         with labels left offset 0.6,-0.3 font ",12", \
     "" index "passes" using "cubic_compression":"percent":\
         (sprintf("%.3f", column("cubic_compression"))) \
         with labels right offset -0.6,-0.3 font ",12"
unset multiplot
