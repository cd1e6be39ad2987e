# strain.gp - strain measures of a body that only turns: from
# rest, with the angles where the linear strain is 1, 5 and 10 %; and how much
# the strains of a stretched body change when it turns.
# Reads   data  tables angles, thresholds
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,410
set output out
set key above left vertical maxrows 3 reverse Left samplen 2.5

set multiplot layout 1,2 margins 0.08,0.985,0.14,0.79 spacing 0.105,0
set xlabel "rotation (degrees)"
set ylabel "size of entry 11 (%)"
set xrange [0:40]
set yrange [-0.8:24]
set xtics 10
set ytics 5
plot data index "angles" using "degrees":(100 * abs(column("linear"))) \
         with linespoints ls 2 title "linear strain, 1 - cos θ", \
     data index "angles" using "degrees":(100 * abs(column("green"))) \
         with linespoints ls 1 title "Green and left strain: 0", \
     data index "thresholds" using (0):(100 * column("level")): \
         "degrees":(0) with vectors nohead ls 8 notitle, \
     data index "thresholds" using "degrees":(100 * column("level")): \
         (0):(-100 * column("level")) with vectors nohead ls 8 notitle, \
     data index "thresholds" using (column("degrees") - 0.6): \
         (100 * column("level") + 0.75): \
         (sprintf("%g %% at %.2f°", 100 * column("level"), \
                  column("degrees"))) \
         with labels right font ",12" notitle

set ylabel "largest change of an entry"
set xrange [0:180]
set yrange [-0.08:2.75]
set xtics 45
set ytics 0.5
plot data index "angles" using "degrees":"linear_change" \
         with linespoints ls 2 pi 5 title "linear", \
     data index "angles" using "degrees":"left_change" \
         with linespoints ls 3 pi 5 title "left, (FF^T - I)/2: turns along", \
     data index "angles" using "degrees":"green_change" \
         with linespoints ls 1 pi 5 title "Green, (F^TF - I)/2: none"
unset multiplot
