# tangent.gp - dP/dF over F for several nu; shaded: negative.
# Reads   data  tables tangent_cubic, tangent_log, thresholds
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 800,430 enhanced font "Helvetica,17"
set output out

stats data index "thresholds" using "nu_cubic" nooutput
nu_cubic = STATS_max
stats data index "thresholds" using "nu_log" nooutput
nu_log = STATS_max
stats data index "thresholds" using "F_cubic" nooutput
F_cubic = STATS_max
stats data index "thresholds" using "F_log" nooutput
F_log = STATS_max

# the laws in their colours, the critical ν thick
array Cubic[4] = ["#7A3500", "#A84800", "#D55E00", "#D55E00"]
array Log[4] = ["#003A5C", "#005688", "#0072B2", "#0072B2"]
set multiplot
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0 \
    fc rgb "#f6dcd0" fs solid noborder behind
set label 1 "softening" at graph 0.03, graph 0.05 \
    textcolor rgb "#8a3c00"
set xlabel "deformation gradient F (-)"
set tmargin at screen 0.96
set bmargin at screen 0.185

unset key
set label 2 "cubic law" at 4.95, -0.65 right
set label 3 "ν = 0.3" at 1.55, 1.45 center tc rgb Cubic[1] boxed
set label 4 "0.1" at 2.3, 0.36 center tc rgb Cubic[2] boxed
set label 5 sprintf("%.3f", nu_cubic) at 2.95, -0.13 center tc rgb Cubic[3]
set label 6 "0.02" at 4.32, 0.8 right tc rgb Cubic[4] boxed
set lmargin at screen 0.12
set rmargin at screen 0.49
set xrange [0:5]
set yrange [-0.8:2.4]
set ylabel "dP/dF over its value at rest, 2μ + λ"
plot data index "tangent_cubic" using "F":"nu_03" with lines lw 2 lc rgb Cubic[1], \
     "" index "tangent_cubic" using "F":"nu_01" with lines lw 2 lc rgb Cubic[2], \
     "" index "tangent_cubic" using "F":"nu_critical" with lines lw 3.5 lc rgb Cubic[3], \
     "" index "tangent_cubic" using "F":"nu_002" with lines lw 2 dt 4 lc rgb Cubic[4], \
     0 with lines ls 9 lw 1, \
     "+" using (F_cubic):(0) every ::0::0 with points pt 7 ps 0.8 \
         lc rgb Cubic[3]

set label 2 "log law" at 31, 0.308 right boxed
set label 3 "ν = 0.3" at 16, 0.27 left tc rgb Log[1] boxed
set label 4 "0.45" at 16, 0.072 left tc rgb Log[2] boxed
set label 5 sprintf("%.3f: touches 0", nu_log) at 5.2, 0.033 left font ",17" tc rgb Log[3] boxed
unset label 6
set label 7 "0.499" at 9, -0.029 left tc rgb Log[4]
set lmargin at screen 0.59
set rmargin at screen 0.985
set logscale x
set xrange [1:32]
set xtics (1, 2, 4, 8, 16, 32)
set yrange [-0.06:0.32]
unset ylabel
plot data index "tangent_log" using "F":"nu_03" with lines lw 2 lc rgb Log[1], \
     "" index "tangent_log" using "F":"nu_045" with lines lw 2 lc rgb Log[2], \
     "" index "tangent_log" using "F":"nu_critical" with lines lw 3.5 lc rgb Log[3], \
     "" index "tangent_log" using "F":"nu_0499" with lines lw 2 dt 4 lc rgb Log[4], \
     0 with lines ls 9 lw 1, \
     "+" using (F_log):(0) every ::0::0 with points pt 7 ps 0.8 \
         lc rgb Log[3]
unset multiplot
