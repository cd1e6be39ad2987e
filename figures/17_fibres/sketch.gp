# sketch.gp - the triangle of the Example and the fibre along its lower edge, at
# rest and deformed: F takes g to l n, and the tension pulls both ends together.
# Beside it the force-length curve of a muscle at full activation, with the
# numbers of fibre_muscle().
# Writes  out   SVG
if (!exists("out"))  out  = "figures/17_fibres/sketch.svg"
load "figures/style.gp"
set terminal svg size 640,740 enhanced font "Helvetica,19" \
    background rgb "white"
set output out
set multiplot
set lmargin at screen 0.01
set rmargin at screen 0.99
set tmargin at screen 0.995
set bmargin at screen 0.55
set size ratio -1
unset border
unset tics
unset grid
unset key
set xrange [-0.2:3.45]
set yrange [-0.45:1.45]
set object 1 polygon from 0, 0 to 1, 0 to 0, 1 to 0, 0 \
    fc rgb "#CFE3F0" fs solid border lc rgb "#0072B2"
set object 2 polygon from 2.35, 0 to 3.07, 0.96 to 1.75, 0.75 to 2.35, 0 \
    fc rgb "#CFE3F0" fs solid border lc rgb "#0072B2"
set arrow 1 from 0, 0 to 1, 0 filled front lw 4 lc rgb "#D55E00"
set arrow 2 from 2.35, 0 to 3.07, 0.96 filled front lw 4 lc rgb "#D55E00"
set arrow 3 from 1.05, 0.55 to 1.6, 0.55 filled lw 1.5 lc rgb "#555555"
set label 1 "g, |g| = 1" at 0.5, -0.16 center
set label 2 "F" at 1.32, 0.68 center font ",21"
set label 3 "F g = l n" at 2.30, 0.60 center
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
unset label
unset arrow
unset object
set size noratio
set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid back ls 9
set lmargin at screen 0.175
set rmargin at screen 0.965
set tmargin at screen 0.52
set bmargin at screen 0.115
set xlabel "stretch l"
set ylabel "tension T (N/m^2)" offset 1
set xrange [0.4:1.7]
set yrange [0:370]
set xtics 0.2
set ytics 100
set samples 521
passive(l) = l > 1 ? 200 * (l - 1)**2 : 0
active(l) = abs(l - 1) < 0.5 ? 300 * (1 - ((l - 1) / 0.5)**2) : 0
set arrow 1 from 1, 0 to 1, 370 nohead ls 9 lw 1.5
set style textbox opaque noborder margins 0.4,0.4
set label 1 "ascending" at 0.72, 340 center front boxed
set label 2 "descending" at 1.33, 340 center front boxed
set label 3 "active" at 0.68, 130 left tc ls 1 front boxed
set label 4 "passive" at 1.2, 46 center tc ls 3 front boxed
set label 5 "both" at 1.415, 180 left tc ls 2 front boxed
plot passive(x) with lines ls 3 lw 2.5, \
     passive(x) + active(x) with lines ls 2 lw 2.5, \
     active(x) with lines ls 1 lw 2.5 dt 2
unset multiplot
set output
