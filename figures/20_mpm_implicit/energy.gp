# energy.gp - energy lost in one period against the number of steps.
# Reads   data  tables energy, elements
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,940 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
set multiplot
set lmargin at screen 0.185
set rmargin at screen 0.97
set tmargin at screen 0.95
set bmargin at screen 0.55
set logscale xy
set xrange [6:420]
set yrange [0.004:1.9]
set xtics (8, 13, 20, 40, 80, 160, 320)
set ytics ("1 %%" 0.01, "3 %%" 0.03, "10 %%" 0.1, "30 %%" 0.3, "100 %%" 1)
set format x ""
set ylabel "energy lost in one period"
unset key
set label 3 "PIC" at 30, 0.5 tc ls 1
set label 4 "FLIP" at 26, 0.17 tc ls 2
set label 5 "APIC" at 180, 0.16 right tc ls 3
set label 1 "explicit steps" at graph 0, graph 1.05
set label 2 "all three\nfail" at 7.3, 0.8 tc rgb "#555555"
set label 6 "dashed: what the transfers\ntake by their filter" at 7.3, 0.0115 tc rgb "#555555"
# what one transfer leaves of the wave z = pi / 8, squared; quadratic kernel
S2 = (sin(pi / 16) / (pi / 16)) ** 6
pic(n) = 1 - S2 ** n
flip(n) = 1 - (1 - (1 / S2 - 1) * (2 * pi / n) ** 2) ** n
plot for [s = 1:3] data index "energy" every ::10*(s-1)::10*s-1 \
         using "steps":"lost" with linespoints ls s, \
     data index "energy" every ::0::1 using "steps":(1.2) with points \
         pt 2 ps 1 lw 2 lc rgb "#555555", \
     [20:320] pic(x) ls 8, [20:320] flip(x) ls 8
set tmargin at screen 0.485
set bmargin at screen 0.085
set xlabel "steps per period"
set xtics ("8" 8, "13" 13, "20" 20, "40" 40, "80" 80, "160" 160, "320" 320)
unset label 2
unset label 6
set label 3 "PIC" at 175, 0.75
set label 4 "FLIP, and finite\nelements (rings)" at 110, 0.075 right tc ls 2
set label 5 "APIC" at 205, 0.4 left
set label 1 "implicit steps, each with 2.3 to 3.1 times the flops"
plot for [s = 1:3] data index "energy" every ::10*(s+2)::10*s+29 \
         using "steps":"lost" with linespoints ls s, \
     data index "elements" using "steps":"lost" with points ls 8 pt 6 ps 1
unset multiplot
