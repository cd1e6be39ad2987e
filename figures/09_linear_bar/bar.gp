# bar.gp - displacement and stress of the bar: the lesson's own numbers, and the
# exact ones.
# Reads   data  tables nodes (X u exact), elements (X P exact)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,360 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
set multiplot layout 1,2 margins 0.11,0.985,0.17,0.96 spacing 0.13,0
unset key
set label 1 "grey: exact" at graph 0.55, 0.2 textcolor rgb "#777777"
set label 2 "computed" at graph 0.55, 0.12 tc ls 1
set xlabel "X (m)"
set xtics 0.2
set ylabel "u (m)"
plot data index "nodes" using "X":"exact" with lines lw 7 lc rgb "#DDDDDD", \
     data index "nodes" using "X":"u" with linespoints ls 1
set label 1 at graph 0.1, 0.2
set label 2 at graph 0.1, 0.12 tc ls 2
set ylabel "P (N/m²)"
set ytics 20
plot data index "elements" using "X":"exact" with lines lw 7 lc rgb "#DDDDDD", \
     data index "elements" using "X":"P" with points ls 2
unset multiplot
