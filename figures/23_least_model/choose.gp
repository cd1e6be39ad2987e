# choose.gp - which model does a scene ask for?  Four numbers of each scene; what
# lies beyond the tolerance, and after a rise what moves by more than half of
# it, has to be added.  On the right, the cheapest model that is within the
# tolerance of the truth.
# Reads   data  table scenes (scene strained bends turned moves least state)
# Writes  out   SVG
if (!exists("data")) data = "build/data/23_least_model/choose.tsv"
if (!exists("out"))  out  = "figures/23_least_model/choose.svg"
load "figures/style.gp"
set terminal svg size 560,500
set output out
set logscale x
least = 3e-3
set xrange [least:30]
set yrange [18.1:-1.4]
set lmargin 14
set rmargin 1
set xtics ("0.01" 0.01, "0.1" 0.1, "1" 1)
set xlabel "number without dimension"
set arrow 1 from 0.1, graph 0 to 0.1, graph 1 nohead ls 8
# of what moves after a rise; no line of the grid, which would cross other words
set arrow 3 from 0.05, graph 0 to 0.05, 16.6 nohead ls 1 lw 1.5
set label 4 "0.05" at 0.05, graph -0.045 center
set label 5 "for moves,\nafter a rise" at 0.046, 16.95 right tc ls 1
set arrow 2 from 2.2, graph 0 to 2.2, graph 1 nohead ls 9
set label 1 "leave it out" at 0.085, 15.95 right textcolor rgb "#555555"
set label 2 "add it" at 0.12, 15.95 left textcolor rgb "#555555"
set label 3 "enough for 10 %" at 2.4, -0.85 left textcolor rgb "#555555"
unset key
set ytics scale 0
unset grid
set grid x back ls 9
# each kind of mark is named once, where there is room beside it
named(scene, number) = strcol("scene") eq scene ? column(number) : NaN
# the ring is wide enough to be seen around a triangle, and the triangle around
# a diamond; two numbers of slender-column, 0.0002 both, are too small
# to be in the picture: an arrow in the colour of neither
plot data index "scenes" using "bends":0 with points ls 8 pt 6 lw 2 ps 1.7, \
     "" index "scenes" using "turned":0:ytic(1) with points ls 2 pt 9 ps 1.15, \
     "" index "scenes" using "moves":0 with points ls 1 pt 5 ps 1.0, \
     "" index "scenes" using "strained":0 with points ls 4 pt 13 ps 0.7, \
     "" index "scenes" using (named("cantilever", "strained")):0:("strained") \
         with labels right offset -1.2,0 tc ls 4, \
     "" index "scenes" using (named("below-buckling", "bends")):0:("bends") \
         with labels left offset 1.4,0 tc ls 8, \
     "" index "scenes" using (named("slow-pull", "turned")):0:("turned") \
         with labels left offset 1.2,0 tc ls 2, \
     "" index "scenes" using (named("fast-pull", "moves")):0:("moves") \
         with labels left offset 1.2,0 tc ls 1, \
     "" index "scenes" using (column("turned") < least ? 9e-3 : NaN):0:(3.3e-3 - 9e-3):(0) \
         with vectors ls 2 lc rgb "#555555", \
     "" index "scenes" using (column("turned") < least ? 0.0138 : NaN):0: \
         (sprintf("strained, turned:\n%.4f each", column("turned"))) with labels left \
         offset 0,0.35 font ",10.5" tc rgb "#555555", \
     "" index "scenes" using (2.4):0:(sprintf("%s, %s", strcol("least"), \
         strcol("state") eq "rest" ? "at rest" : "in motion")) with labels left
