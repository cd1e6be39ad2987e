# chart.gp - speed against accuracy: the error of F after k
# linear solves, log law at p = -1.5 (2 mu + lambda), for each cure.
# Reads   data  tables chart, chart_reasons
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 720,460 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
set logscale y
set format y "10^{%T}"
set xlabel "linear systems"
set ylabel "relative error of F"
set xrange [-0.4:16.4]
set yrange [2e-15:2e4]
set ytics 1e-14, 1e4
unset mytics
unset key
set label 4 "line search" at 5.2, 1e-5 tc ls 3 boxed
set label 5 "better start" at 3.8, 1e-9 right tc ls 4 boxed
set label 6 "load stepping" at 13.9, 3e-8 right tc ls 5 boxed
set label 1 "cubic law: another answer" at 7.3, 0.05 tc ls 2 boxed
set label 3 "ring: the linear law; the cross in it:\nplain Newton, which ends inverted" at 1.5, 3e3 boxed
set label 2 "round-off" at 10, 4e-14 tc rgb "#555555"
set object 1 rectangle from -0.4, 2e-15 to 16.4, 1e-13 back \
    fc rgb "#EEEEEE" fs solid noborder
# A curve ends at its answer; of round-off there is only that it is there.
shown(name) = (before = column(0) == 0 ? NaN : now, now = column(name), \
    abs(now - before) < 1e-12 && now < 0.3 ? NaN : now < 1e-13 ? 1.3e-14 : now)
plot data index "chart" every ::1::1 using "solves":"plain" \
         with points pt 2 ps 2 lw 2 lc rgb "#0072B2", \
     data index "chart" using "solves":(shown("stepping")) \
         with linespoints ls 5, \
     data index "chart" using "solves":(shown("search")) \
         with linespoints ls 3, \
     data index "chart" using "solves":(shown("start")) \
         with linespoints ls 4, \
     data index "chart" using "solves":(shown("cubic")) \
         with linespoints ls 2, \
     data index "chart_reasons" using (1):"linear" with points pt 6 ps 2 \
         lw 1.5 lc rgb "black"
