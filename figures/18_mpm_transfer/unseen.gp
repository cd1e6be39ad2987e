# unseen.gp - a motion that the grid does not see, on top of one that it sees:
# what FLIP, PIC and APIC leave of it.  Quadratic kernel, four per cell.
# Reads   data  table modes
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,420
set output out
set multiplot layout 1,2 margins 0.08,0.985,0.14,0.80 spacing 0.08,0
set xrange [0:8]
set yrange [-1.75:1.75]
set xtics 1
set xlabel "x (cells)"
set ylabel "velocity (m/s)"
set key above left maxrows 2 samplen 2
plot data index "modes" using "x":"start" with lines lc rgb "#CCCCCC" lw 1 \
         notitle, \
     "" index "modes" using "x":"start" with points ls 2 \
         title "before", \
     cos(pi * x / 8) ls 8 title "the part that the nodes see"
unset ylabel
plot data index "modes" using "x":"flip" with lines lc rgb "#CCCCCC" lw 1 \
         notitle, \
     "" index "modes" using "x":"flip" with points ls 2 \
         title "after 100 transfers by FLIP", \
     "" index "modes" using "x":"pic" with points ls 1 \
         title "after one by PIC", \
     "" index "modes" using "x":"apic" with points ls 3 pt 8 ps 0.8 \
         title "after one by APIC (B = 0 before)", \
     cos(pi * x / 8) ls 8 notitle
unset multiplot
