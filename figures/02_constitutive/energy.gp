# energy.gp - Figure 6 of the notes, first of three: the energy over F in one
# dimension, of the log and of the cubic law (dashed: linear), as the lesson prints it.
# Reads   data  tables curve_log, curve_cubic, curve_linear
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 270,300 enhanced font "Helvetica,14"
set output out
set key above center horizontal maxrows 1 reverse Left samplen 1.5 width -2
set lmargin at screen 0.28
set rmargin at screen 0.97
set tmargin at screen 0.88
set bmargin at screen 0.2
set xrange [-1:3]
set xtics 1
set yrange [0:4000]
set ytics 1000
set xlabel "deformation gradient F (-)" offset 0,0.4
set ylabel "energy ψ (J/m^3)" offset 1.3
set object 1 rectangle from graph 0, graph 0 to first 0, graph 1 \
    fc rgb "#eeeeee" fs solid noborder behind
set label 1 "inside\nout" at -0.94, 600 textcolor rgb "#555555"
set label 2 "linear" at 2.75, 2350 right
flat(of) = column("F") == 0 ? column(of) : NaN # crushed flat
behind = exists("reference") # grey, where the data are a student's
if (!behind) reference = data
plot for [law in "log cubic"] reference index "curve_".law \
         using "F":(behind ? column("psi") : NaN) with lines lw 7 \
         lc rgb "#DDDDDD" notitle, \
     data index "curve_linear" using "F":"psi" with lines ls 8 lw 1.5 notitle, \
     data index "curve_log" using "F":"psi" with lines ls 1 title "log", \
     data index "curve_cubic" using "F":"psi" with lines ls 2 title "cubic", \
     data index "curve_cubic" using "F":(flat("psi")) with points pt 7 ps 0.6 \
         lc rgb "#D55E00" notitle, \
     data index "curve_cubic" using "F":(flat("psi")): \
         (sprintf("ψ(0) = %.0f", column("psi"))) with labels \
         left offset 2.3,0.4 tc ls 2 notitle
