# chart.gp - the chart of the course: the work of the richest model of a scene
# over all that it takes to find one that meets a tolerance; hollow: over that of
# the cheapest, if somebody names it; and what the band saves of the richest
# model's dense factors.
# Reads   data  table chart (scene named ten one tenth dense cholesky)
# Writes  out   SVG
if (!exists("data")) data = "build/data/23_least_model/chart.tsv"
if (!exists("out"))  out  = "figures/23_least_model/chart.svg"
load "figures/style.gp"
set terminal svg size 860,520
set output out
set logscale x
set xrange [0.3:1e7]
set yrange [12.1:-0.7]
set lmargin 16
set format x "10^{%T}"
set xlabel "work saved, as a factor"
set key above left vertical maxrows 3 reverse Left samplen 1.5 width -16
set label 1 "no point: none of the meshes here is fine enough" at 7e6, 11.6 right font ",11" textcolor rgb "#555555"
set arrow 1 from 1, graph 0 to 1, graph 1 nohead ls 8
set ytics scale 0
unset grid
set grid x back ls 9
plot data index "chart" using "named":0:ytic(1) with impulses lc rgb "white" notitle, \
     "" index "chart" using (1):0:(column("ten") - 1):(0) with vectors nohead lw 5 lc rgb "#BBD6E8" notitle, \
     "" index "chart" using "ten":0 with points ls 1 ps 1.3 title "found, for 10 %", \
     "" index "chart" using "one":0 with points ls 2 ps 1.2 title "found, for 1 %", \
     "" index "chart" using "tenth":0 with points ls 3 ps 1.4 title "found, for 0.1 %", \
     "" index "chart" using "cholesky":0 with points ls 1 pt 12 ps 1.1 lw 1.5 title "for 10 %, without the bound", \
     "" index "chart" using "named":0 with points ls 1 pt 6 ps 1.3 title "for 10 %, if somebody names the model", \
     "" index "chart" using "dense":0 with points pt 2 ps 1.0 lw 2 lc rgb "black" \
         title "by the solver: band for dense"
