# bar.gp - displacement and stress of the bar: the lesson's own numbers, and the
# exact ones.
# Reads   data  tables nodes (X u exact), elements (X P exact)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,400 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
set multiplot layout 1,2 margins 0.125,0.985,0.17,0.96 spacing 0.14,0
unset key
set label 1 "grey: exact" at graph 0.55, 0.2 textcolor rgb "#777777" boxed
set label 2 "computed" at graph 0.55, 0.11 tc ls 1 boxed
set xlabel "X (m)"
set xtics 0.5
set ylabel "u (m)" offset 1,0
plot data index "nodes" using "X":"exact" with lines lw 7 lc rgb "#DDDDDD", \
     data index "nodes" using "X":"u" with linespoints ls 1
set label 1 at graph 0.1, 0.2
set label 2 at graph 0.1, 0.11 tc ls 2 boxed
set ylabel "P (N/m²)"
set ytics 20
plot data index "elements" using "X":"exact" with lines lw 7 lc rgb "#DDDDDD", \
     data index "elements" using "X":"P" with points ls 2
unset multiplot
