# poisson.gp - the jump at which the notes' method first fails, over Poisson's
# ratio.
# Reads   data  table poisson (nu cubic log)
# Writes  out   SVG
load "figures/style.gp"
set output out
set xlabel "Poisson's ratio ν"
set ylabel "first jump that fails, over h"
set xrange [0:0.5]
set yrange [0:1.25]
unset key
set label 1 "the triangles at the end are flat" at 0.49, 1.04 right tc rgb "#555555"
set label 2 "cubic law" at 0.185, 1.16 tc ls 2
set label 3 "log law" at 0.21, 0.82 tc ls 1
set arrow 1 from 0, 1 to 0.5, 1 nohead ls 8
plot data index "poisson" using "nu":"cubic" with linespoints ls 2, \
     "" index "poisson" using "nu":"log" with linespoints ls 1
