# chart.gp - the chart of the course: the work of the richest model of a scene
# over all that it takes to find one that meets a tolerance; hollow: over that of
# the cheapest, if somebody names it.
# Reads   data  table chart (scene named ten one tenth)
# Writes  out   SVG
if (!exists("data")) data = "build/data/23_least_model/chart.tsv"
if (!exists("out"))  out  = "figures/23_least_model/chart.svg"
load "figures/style.gp"
set terminal svg size 600,470
set output out
set logscale x
set xrange [0.2:1e7]
set yrange [12.1:-1.4]
set lmargin 16
set tmargin 1
set format x "10^{%T}"
set xlabel "flops of the richest model over yours"
unset key
set arrow 1 from 1, -0.35 to 1, graph 0 nohead ls 8
set label 1 "1: nothing saved" at 1.15, 11.75 boxed
# what the marks are, at those of the first rows
set label 2 "0.1 %" at 0.5, -0.75 center tc ls 3
set label 3 "1 %" at 26, -0.75 center tc ls 2 boxed
set label 4 "found, for an error of 10 %" at 1.6e4, -0.75 center tc ls 1 boxed
set label 5 "known" at 5e5, 0 right tc ls 1 boxed
set style textbox opaque noborder margins 0.3, 0
set label 7 "no mark: the meshes here are too coarse" at 7e6, 11.75 right boxed
set ytics scale 0
unset grid
set grid x back ls 9
plot data index "chart" using "named":0:ytic(1) with impulses lc rgb "white", \
     "" index "chart" using (1):0:(column("ten") - 1):(0) with vectors nohead lw 5 lc rgb "#BBD6E8", \
     "" index "chart" using "ten":0 with points ls 1 ps 1.3, \
     "" index "chart" using "one":0 with points ls 2 ps 1.2, \
     "" index "chart" using "tenth":0 with points ls 3 ps 1.4, \
     "" index "chart" using "named":0 with points ls 1 pt 6 ps 1.3
