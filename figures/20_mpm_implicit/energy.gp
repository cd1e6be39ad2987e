# energy.gp - energy lost in one period against the number of steps.
# Reads   data  tables energy, elements
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 780,410
set output out
set multiplot layout 1,2 margins 0.11,0.985,0.14,0.93 spacing 0.06,0
set logscale xy
set xrange [6:420]
set yrange [0.008:1.9]
set xtics (10, 20, 40, 80, 160, 320)
set ytics ("1 %%" 0.01, "3 %%" 0.03, "10 %%" 0.1, "30 %%" 0.3, "100 %%" 1)
set xlabel "steps per period"
set ylabel "energy lost in one period"
unset key
set label 3 "PIC" at 30, 0.5 tc ls 1
set label 4 "FLIP" at 170, 0.013 right tc ls 2
set label 5 "APIC" at 180, 0.15 right tc ls 3
set label 1 "explicit steps" at graph 0.02, graph 1.04
set label 2 "all three fail" at 6.5, 1.55 tc rgb "#555555"
plot for [s = 1:3] data index "energy" every ::7*(s-1)::7*s-1 \
         using "steps":"lost" with linespoints ls s, \
     data index "energy" every ::0::1 using "steps":(1.2) with points \
         pt 2 ps 1 lw 2 lc rgb "#555555"
unset ylabel
set format y ""
unset label 2
set label 3 "PIC" at 170, 0.78
set label 4 "FLIP, and finite\nelements (rings)" at 150, 0.085 right tc ls 2
set label 5 "APIC" at 200, 0.4
set label 1 "implicit steps"
plot for [s = 1:3] data index "energy" every ::7*(s+2)::7*s+20 \
         using "steps":"lost" with linespoints ls s, \
     data index "elements" using "steps":"lost" with linespoints ls 8 pt 6 \
         ps 1
unset multiplot
