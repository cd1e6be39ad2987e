# choose.gp - which model does a scene ask for?  Three numbers of each scene; what
# lies beyond the tolerance has to be added.  On the right, the cheapest model
# that is within the tolerance of the truth.
# Reads   data  table scenes (scene bends turned moves least state)
# Writes  out   SVG
if (!exists("data")) data = "build/data/23_least_model/choose.tsv"
if (!exists("out"))  out  = "figures/23_least_model/choose.svg"
load "figures/style.gp"
set terminal svg size 860,540
set output out
set logscale x
set xrange [1e-4:150]
set yrange [15.6:-0.7]
set lmargin 16
set xtics 1e-4, 10, 1
set format x "10^{%T}"
set xlabel "number without dimension"
set arrow 1 from 0.1, graph 0 to 0.1, graph 1 nohead ls 8
set arrow 2 from 4, graph 0 to 4, graph 1 nohead ls 9
set label 1 "leave it out" at 0.085, 15.1 right font ",12" textcolor rgb "#555555"
set label 2 "add it" at 0.12, 15.1 left font ",12" textcolor rgb "#555555"
set label 3 "enough for 10 %" at 5, 15.1 left font ",12" textcolor rgb "#555555"
set key above left vertical maxrows 3 reverse Left samplen 1.5
set ytics scale 0
unset grid
set grid x back ls 9
plot data index "scenes" using "bends":0:ytic(1) with points ls 8 pt 6 lw 2 ps 1.2 \
         title "bends: a bar cannot; take triangles (lesson 12)", \
     "" index "scenes" using "turned":0 with points ls 2 pt 9 ps 1.4 \
         title "turned, or under stress while it turns: take a nonlinear law (lessons 11 and 15)", \
     "" index "scenes" using "moves":0 with points ls 1 pt 5 ps 1.0 \
         title "moves: take time steps (lessons 13 and 14)", \
     "" index "scenes" using (5.0):0:(sprintf("%s, %s", strcol("least"), \
         strcol("state") eq "rest" ? "at rest" : "in motion")) \
         with labels left font ",12" notitle
