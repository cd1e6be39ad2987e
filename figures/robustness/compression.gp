# compression.gp - the ends pushed together, n = 8: linear systems of each step
# and least J after it; crosses: the step that failed.
# Reads   data  tables path_notes, path_always, path_demand, path_log_notes,
#               path_log_halved
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,640
set output out
array Name[5] = ["path_notes", "path_demand", "path_always", \
    "path_log_notes", "path_log_halved"]
array Style[5] = [2, 3, 4, 1, 6]
ok(what) = strcol("reason") eq "OK" ? column(what) : NaN
lost(value) = strcol("reason") ne "OK" ? value : NaN
set multiplot
set lmargin at screen 0.115
set rmargin at screen 0.985
set xrange [0:2.02]
set arrow 1 from pi / 2, graph 0 to pi / 2, graph 1 nohead ls 8
set tmargin at screen 0.97
set bmargin at screen 0.54
unset key
set label 2 "cubic, always projecting" at 0.03, 120 tc ls 4
set label 3 "cubic, on demand" at 1.53, 2.55 right tc ls 3
set label 4 "log, all cures,\nhalved steps" at 1.34, 420 right tc ls 6
set label 5 "log, notes' method" at 0.56, 1300 right tc ls 1
set label 6 "cubic, notes' method" at 0.81, 1300 tc ls 2
set logscale y
set yrange [2:2000]
set format x ""
set label 1 "× the step failed" at 0.03, 520 textcolor rgb "#555555"
set ylabel "linear systems per step"
plot for [k = 1:5] data index Name[k] using "t":(ok("iterations")) \
         with linespoints ls Style[k], \
     for [k = 1:5] data index Name[k] using "t":(lost(1300)) \
         with points pt 2 ps 1.2 lw 3 lc rgb word("#D55E00 #009E73 #CC79A7 \
#0072B2 #56B4E9", k) notitle
do for [i = 1:6] { unset label i }
unset logscale y
set tmargin at screen 0.50
set bmargin at screen 0.10
set format x "%g"
set xlabel "t (s); the ends have moved by sin t each and meet at π/2"
set ylabel "least J after the step"
set yrange [-0.12:1.02]
set arrow 2 from graph 0, first 0 to graph 1, first 0 nohead ls 8
set label 7 "log, all cures,\nhalved steps" at 0.87, 0.34 tc ls 6
set label 8 "cubic, both ways of projecting" at 1.58, 0.22 center tc ls 4
set label 9 "cubic, notes' method" at 0.69, -0.07 right tc ls 2
set label 10 "log, notes' method" at 0.64, 0.42 tc ls 1
set label 11 "inverted, yet OK" at 1.555, -0.07 right tc ls 4
plot for [k = 1:5] data index Name[k] using "t":(ok("min_J")) \
         with linespoints ls Style[k], \
     for [k = 1:5] data index Name[k] using "t":(lost(column("min_J"))) \
         with points pt 2 ps 1.2 lw 3 lc rgb word("#D55E00 #009E73 #CC79A7 \
#0072B2 #56B4E9", k) notitle
unset multiplot
