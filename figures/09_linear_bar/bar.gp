# bar.gp - displacement and stress of the bar: the lesson's own numbers, and the
# exact ones.
# Reads   data  tables nodes (X u exact), elements (X P exact)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,360
set output out
set multiplot layout 1,2 margins 0.1,0.985,0.15,0.86 spacing 0.12,0
set xlabel "X (m)"
set xtics 0.2
set ylabel "u (m)"
plot data index "nodes" using "X":"exact" with lines lw 7 lc rgb "#DDDDDD" \
         title "exact", \
     data index "nodes" using "X":"u" with linespoints ls 1 title "computed"
set ylabel "P (N/m^2)"
set ytics 20
plot data index "elements" using "X":"exact" with lines lw 7 lc rgb "#DDDDDD" \
         title "exact", \
     data index "elements" using "X":"P" with points ls 2 title "computed"
unset multiplot
