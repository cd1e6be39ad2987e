# unseen.gp - a motion that the grid does not see, on top of one that it sees
# (above): what FLIP, PIC and APIC leave of it.  Quadratic kernel, four per cell.
# Reads   data  table modes
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,760 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set multiplot layout 2,1 margins 0.15,0.97,0.10,0.95 spacing 0,0.09
set xrange [0:8]
set yrange [-1.75:1.75]
set xtics 1
set ytics 0.5
set ylabel "velocity (m/s)"
set format x ""
unset key
set label 1 "before; dashed: what the nodes see" at graph 0, graph 1.06
plot data index "modes" using "x":"start" with lines lc rgb "#CCCCCC" lw 1, \
     "" index "modes" using "x":"start" with points ls 2 lc rgb "#555555", \
     cos(pi * x / 8) ls 8
set format x "%g"
set xlabel "x (cells)"
set label 1 "100 transfers with FLIP" tc ls 2
set label 2 "1 with PIC, or with APIC from B = 0" at graph 1, graph 1.06 right \
    tc ls 1
plot data index "modes" using "x":"flip" with lines lc rgb "#CCCCCC" lw 1, \
     "" index "modes" using "x":"flip" with points ls 2, \
     "" index "modes" using "x":"pic" with points ls 1
unset multiplot
