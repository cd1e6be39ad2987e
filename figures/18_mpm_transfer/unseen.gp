# unseen.gp - a motion that the grid does not see, on top of one that it sees:
# what FLIP, PIC and APIC leave of it.  Quadratic kernel, four per cell.
# Reads   data  table modes
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 780,400
set output out
set multiplot layout 1,2 margins 0.08,0.985,0.15,0.90 spacing 0.08,0
set xrange [0:8]
set yrange [-1.75:2.5]
set xtics 1
set xlabel "x (cells)"
set ylabel "velocity (m/s)"
unset key
set title "before"
set label 1 "dashed: what the nodes see" at 7.9, 2.2 right
plot data index "modes" using "x":"start" with lines lc rgb "#CCCCCC" lw 1 \
        , \
     "" index "modes" using "x":"start" with points ls 2, \
     cos(pi * x / 8) ls 8
unset ylabel
set title "after"
set label 1 "100 transfers with FLIP" at 7.9, 2.3 right tc ls 2
set label 2 "1 transfer with PIC, or with APIC from B = 0" at 7.9, 2.05 right tc ls 1
plot data index "modes" using "x":"flip" with lines lc rgb "#CCCCCC" lw 1 \
        , \
     "" index "modes" using "x":"flip" with points ls 2, \
     "" index "modes" using "x":"pic" with points ls 1, \
     cos(pi * x / 8) ls 8
unset multiplot
