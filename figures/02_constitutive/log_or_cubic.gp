# 02_constitutive_figure6.gp - Figure 6 of the notes, energy and stress of the
# log and the cubic law in one dimension, and how far apart they are.
# Reads   data  tables curve_log, curve_cubic, curve_linear, difference, passes
# Writes  out   SVG
if (!exists("data")) data = "build/data/02_constitutive.tsv"
if (!exists("out"))  out  = "figures/02_constitutive_figure6.svg"
load "figures/style.gp"
set terminal svg size 860,660
set output out

set multiplot
set xrange [-1:3]
set xtics 1
set xlabel "deformation gradient F (-)"
set object 1 rectangle from graph 0, graph 0 to first 0, graph 1 \
    fc rgb "#eeeeee" fs solid noborder behind
set label 1 "inside out" at graph 0.02, graph 0.06 font ",12" \
    textcolor rgb "#555555"
set tmargin at screen 0.885
set bmargin at screen 0.58
set key at screen 0.08, screen 0.985 left top vertical maxrows 3 \
    reverse Left samplen 3

set lmargin at screen 0.09
set rmargin at screen 0.48
set ylabel "energy ψ (J/m^3)"
set yrange [0:4000]
set ytics 1000
plot data index "curve_log" using "F":"psi" with lines ls 1 \
         title "log (F > 0 only)", \
     "" index "curve_cubic" using "F":"psi" with lines ls 2 \
         title "cubic", \
     "" index "curve_linear" using "F":"psi" with lines ls 8 title "linear"

set lmargin at screen 0.59
set rmargin at screen 0.98
set ylabel "stress P (N/m^2)" offset 0.5
set yrange [-9000:5000]
set ytics 2000
set label 1 "inside out" at graph 0.02, graph 0.93
set label 2 "cubic: P(0) = -(11λ/2 + 3μ)" at 0.55, -5400 left \
    font ",12"
unset key
plot data index "curve_log" using "F":"P" with lines ls 1 notitle, \
     "" index "curve_cubic" using "F":"P" with lines ls 2 notitle, \
     "" index "curve_linear" using "F":"P" with lines ls 8 notitle, \
     "" index "curve_cubic" using "F":(column("F") == 0 ? column("P") : NaN) \
         with points pt 7 ps 0.8 lc rgb "#D55E00" notitle, \
     0 with lines ls 9 notitle

# ---- the difference, in per cent, on a logarithmic scale
unset object 1
unset label
set tmargin at screen 0.43
set bmargin at screen 0.09
set lmargin at screen 0.09
set rmargin at screen 0.98
set key at screen 0.09, screen 0.49 left top horizontal maxrows 1 \
    reverse Left samplen 3 width 2
set xrange [0.3:3.04]
set xtics 0.5
set logscale y
set yrange [0.08:500]
set format y "%g"
set ytics (0.1, 1, 5, 10, 100)
set ylabel "difference of stress (%)" offset 0.5
below(c) = column("F") < 1 ? abs(column(c)) : NaN # no line across F = 1
above(c) = column("F") > 1 ? abs(column(c)) : NaN
plot data index "difference" using "F":(below("cubic")) with lines ls 2 \
         title "|P_{cubic} / P_{log} - 1|", \
     "" index "difference" using "F":(below("linear")) with lines ls 8 \
         title "|P_{linear} / P_{log} - 1|", \
     "" index "difference" using "F":(above("cubic")) with lines ls 2 notitle, \
     "" index "difference" using "F":(above("linear")) with lines ls 8 notitle, \
     "" index "passes" using "cubic_tension":"percent" \
         with points pt 7 ps 0.8 lc rgb "#D55E00" \
         title "first at 1, 5, 10 %", \
     "" index "passes" using "cubic_compression":"percent" \
         with points pt 7 ps 0.8 lc rgb "#D55E00" notitle, \
     "" index "passes" using "cubic_tension":"percent":\
         (sprintf("F = %.3f", column("cubic_tension"))) \
         with labels right offset -0.4,0.35 font ",12" notitle, \
     "" index "passes" using "cubic_compression":"percent":\
         (sprintf("%.3f", column("cubic_compression"))) \
         with labels left offset 0.4,0.35 font ",12" notitle
unset multiplot
