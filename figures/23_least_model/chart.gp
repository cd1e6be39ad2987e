# chart.gp - the chart of the course: the work of the richest model of a scene
# over that of the cheapest which meets a tolerance; and what the band saves of
# the richest model's dense factors.
# Reads   data  table chart (scene ten one tenth dense)
# Writes  out   SVG
if (!exists("data")) data = "build/data/23_least_model/chart.tsv"
if (!exists("out"))  out  = "figures/23_least_model/chart.svg"
load "figures/style.gp"
set terminal svg size 860,500
set output out
set logscale x
set xrange [0.7:1e7]
set yrange [11.7:-0.7]
set lmargin 16
set format x "10^{%T}"
set xlabel "work saved, as a factor"
set key above left vertical maxrows 2 reverse Left samplen 1.5 width 2
set label 1 "no point: none of the meshes here is fine enough" at 3e6, 11.35 right font ",11" textcolor rgb "#555555"
set ytics scale 0
unset grid
set grid x back ls 9
plot data index "chart" using "ten":0:ytic(1) with impulses lc rgb "white" notitle, \
     "" index "chart" using (1):0:(column("ten") - 1):(0) with vectors nohead lw 5 lc rgb "#BBD6E8" notitle, \
     "" index "chart" using "ten":0 with points ls 1 ps 1.3 title "by thinking, for 10 %", \
     "" index "chart" using "one":0 with points ls 2 ps 1.2 title "for 1 %", \
     "" index "chart" using "tenth":0 with points ls 3 ps 1.4 title "for 0.1 %", \
     "" index "chart" using "dense":0 with points pt 2 ps 1.0 lw 2 lc rgb "black" \
         title "by the solver: band for dense"
