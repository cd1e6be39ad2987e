# compression.gp - the ends pushed together, n = 8: linear systems of each step
# and least J after it; crosses: where the run ends, above in a strip of its own.
# Reads   data  tables path_notes, path_always, path_demand, path_log_halved
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,680
set output out
# the notes' method above projection on demand, with which it begins
array Name[4] = ["path_always", "path_demand", "path_notes", "path_log_halved"]
array Style[4] = [4, 3, 2, 6]
array Wide[4] = [2, 5, 2, 2]
array Color[4] = ["#CC79A7", "#009E73", "#D55E00", "#56B4E9"]
DARK = "#0072B2" # what is said of the last, which is too light for letters
ok(what) = strcol("reason") eq "OK" ? column(what) : NaN
FAILED = 1300 # where the strip is, which has no scale
lost(value) = strcol("reason") ne "OK" ? value : NaN
set multiplot
set lmargin at screen 0.125
set rmargin at screen 0.975
set grid noxtics ytics
set xrange [0:2.02]
set arrow 1 from pi / 2, graph 0 to pi / 2, graph 1 nohead ls 8
set tmargin at screen 0.97
set bmargin at screen 0.55
unset key
set label 2 "cubic, always projecting" at 0.03, 140 tc ls 4
set label 3 "cubic, on demand" at 1.59, 6.3 tc ls 3
set label 4 "log, all cures,\nhalved steps" at 1.34, 700 right tc rgb DARK
set label 5 "a triangle is flat" at 1.61, FAILED tc rgb DARK
set label 6 "cubic, notes' method" at 0.80, FAILED tc ls 2
set logscale y
set yrange [2:2000]
set object 1 rectangle from graph 0, first 850 to graph 1, graph 1 behind \
    fc rgb "#EEEEEE" fs solid noborder
set ytics (3, 10, 30, 100, 300)
set format x ""
set label 1 "× the run ends" at 0.03, FAILED textcolor rgb "#555555"
set ylabel "linear systems per step"
plot for [k = 1:4] data index Name[k] using "t":(ok("iterations")) \
         with lines lw Wide[k] lc rgb Color[k], \
     for [k = 1:4] data index Name[k] using "t":(ok("iterations")) \
         every 4 with points ls Style[k], \
     for [k = 1:4] data index Name[k] using "t":(lost(FAILED)) \
         with points pt 2 ps 1.2 lw 3 lc rgb Color[k]
do for [i = 1:6] { unset label i }
unset logscale y
unset object 1
set ytics autofreq
set tmargin at screen 0.51
set bmargin at screen 0.10
set format x "%g"
set xlabel "t (s); the ends have moved by sin t each and meet at π/2"
set ylabel "least J after the step"
set yrange [-0.12:1.02]
set arrow 2 from graph 0, first 0 to graph 1, first 0 nohead ls 8
set label 7 "log, all cures,\nhalved steps" at 0.78, 0.37 tc rgb DARK
set label 8 "cubic,\nalways projecting\nor on demand" at 1.60, 0.51 tc ls 4
set label 9 "cubic, notes' method" at 0.66, -0.07 right tc ls 2
set label 11 "inverted, yet OK" at 1.1, -0.07 textcolor rgb "#555555"
set arrow 3 from 1.09, -0.07 to 1.045, -0.063 nohead lc rgb "#555555"
plot for [k in "1 3 4"] data index Name[k + 0] using "t":(ok("min_J")) \
         with lines lw 2 lc rgb Color[k + 0], \
     for [k in "1 3 4"] data index Name[k + 0] using "t":(ok("min_J")) \
         every 4 with points ls Style[k + 0], \
     for [k in "3 4"] data index Name[k + 0] using "t":(lost(column("min_J"))) \
         with points pt 2 ps 1.2 lw 3 lc rgb Color[k + 0]
unset multiplot
