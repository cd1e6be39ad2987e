# laws.gp - the stress of a bar over F, three laws: the lesson's own numbers.
# Reads   data  tables curve_linear, curve_log, curve_cubic (F P)
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
if (!exists("reference")) reference = data
set terminal svg size 620,400 enhanced font "Helvetica,13"
set output out
array Law[3] = ["linear", "log", "cubic"]
array Style[3] = [8, 1, 2]
set xlabel "F"
set ylabel "P (kN/m^2)"
set yrange [-8:8]
unset key
set label 1 "linear" at -0.9, -1.4 left boxed
set label 2 "log" at 0.3, -6.5 left tc ls 1 boxed
set label 3 "cubic" at -0.3, -6.5 right tc ls 2 boxed
set label 4 "grey: the reference solution" at 2.95, -7 right tc rgb "#777777" boxed
plot for [i = 1:3] reference index "curve_".Law[i] using "F":(column("P") / 1000) \
         with lines lw 7 lc rgb "#DDDDDD", \
     for [i = 1:3] data index "curve_".Law[i] using "F":(column("P") / 1000) \
         with lines ls Style[i] lw 2
