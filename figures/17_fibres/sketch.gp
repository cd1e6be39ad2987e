# sketch.gp - the triangle of the Example and the fibre along its lower edge, at
# rest and deformed: F takes g to l n, and the tension pulls both ends together.
# Writes  out   SVG
if (!exists("out"))  out  = "figures/17_fibres/sketch.svg"
load "figures/style.gp"
set terminal svg size 620,300
set output out
set size ratio -1
unset border
unset tics
unset grid
unset key
set xrange [-0.35:3.55]
set yrange [-0.35:1.55]
set object 1 polygon from 0, 0 to 1, 0 to 0, 1 to 0, 0 \
    fc rgb "#CFE3F0" fs solid border lc rgb "#0072B2"
set object 2 polygon from 2.35, 0 to 3.07, 0.96 to 1.75, 0.75 to 2.35, 0 \
    fc rgb "#CFE3F0" fs solid border lc rgb "#0072B2"
set arrow 1 from 0, 0 to 1, 0 filled front lw 4 lc rgb "#D55E00"
set arrow 2 from 2.35, 0 to 3.07, 0.96 filled front lw 4 lc rgb "#D55E00"
set arrow 3 from 1.05, 0.55 to 1.6, 0.55 filled lw 1.5 lc rgb "#555555"
set label 1 "g, |g| = 1" at 0.5, -0.16 center
set label 2 "F" at 1.32, 0.68 center font ",16"
set label 3 "F g = l n" at 2.42, 0.52 center
set label 4 "at rest" at 0.3, 1.25 center
set label 5 "deformed" at 2.35, 1.25 center
# the tension: on vertex 0 along n, on vertex 1 against it
set arrow 4 from 2.52, -0.03 to 2.736, 0.258 filled front lw 2.5 \
    lc rgb "#009E73"
set arrow 5 from 3.24, 0.93 to 3.024, 0.642 filled front lw 2.5 \
    lc rgb "#009E73"
set label 6 "T" at 2.74, 0.06 center tc rgb "#009E73"
set label 7 "T" at 3.24, 0.72 center tc rgb "#009E73"
plot NaN notitle
set output
