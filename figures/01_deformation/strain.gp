# strain.gp - strain measures of a body that only turns: from
# rest, with the angles where the linear strain is 1, 5 and 10 %; and how much
# the strains of a stretched body change when it turns.
# Reads   data  tables angles, thresholds
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 780,390 enhanced font "Helvetica,16"
set output out
unset key

set multiplot layout 1,2 margins 0.095,0.972,0.195,0.955 spacing 0.135,0
set xlabel "rotation (degrees)"
set ylabel "size of entry 11 of the strain (%)"
set xrange [0:40]
set yrange [-2.6:24]
set xtics 10
set ytics 5
set label 1 "linear: 1 - cos θ" at 27.5, 14 right tc ls 2 boxed
set label 2 "Green, left strain: 0" at 39.5, -1.5 right tc ls 1 boxed
plot data index "angles" using "degrees":(100 * abs(column("linear"))) \
         with linespoints ls 2 notitle, \
     data index "angles" using "degrees":(100 * abs(column("green"))) \
         with linespoints ls 1 notitle, \
     data index "thresholds" using (0):(100 * column("level")): \
         "degrees":(0) with vectors nohead ls 8 notitle, \
     data index "thresholds" using "degrees":(100 * column("level")): \
         (0):(-100 * column("level")) with vectors nohead ls 8 notitle, \
     data index "thresholds" using (0.3): \
         (100 * column("level") + 0.9): \
         (sprintf("%g %%: %.1f°", 100 * column("level"), \
                  column("degrees"))) \
         with labels left boxed font ",13.5" notitle

set ylabel "largest change of an entry"
set xrange [0:180]
set yrange [-0.3:2.75]
set xtics 45
set ytics 0.5
set label 1 "linear" at 88, 1.6 right tc ls 2 boxed
set label 2 "left: changes" at 179, 0.5 right tc ls 3 boxed
set label 3 "Green: none" at 179, -0.14 right tc ls 1 boxed
plot data index "angles" using "degrees":"linear_change" \
         with linespoints ls 2 pi 5 notitle, \
     data index "angles" using "degrees":"left_change" \
         with linespoints ls 3 pi 5 notitle, \
     data index "angles" using "degrees":"green_change" \
         with linespoints ls 1 pi 5 notitle
unset multiplot
