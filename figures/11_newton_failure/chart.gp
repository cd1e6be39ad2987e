# chart.gp - speed against accuracy: the error of F after k
# linear solves, log law at p = -1.5 (2 mu + lambda), for each cure.
# Reads   data  tables chart, chart_reasons
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 720,460
set output out
set style line 5 lc rgb "#E69F00" lw 2 pt 11 ps 0.7
set logscale y
set format y "10^{%T}"
set xlabel "linear solves"
set ylabel "relative error of F"
set xrange [-0.4:20.4]
set yrange [2e-17:10]
set key above left maxrows 3 samplen 2
set label 1 "another law, another answer" at 7.3, 0.06 font ",12"
set label 2 "round-off" at 0.2, 3e-16 font ",12"
floor_(x) = x < 1e-15 ? 1.348e-16 : x # of round-off only that it is there
plot data index "chart" every ::1::1 using "solves":"plain" \
         with points pt 2 ps 1.2 lw 2 lc rgb "#0072B2" \
         title "plain Newton: inverted in solve 1", \
     data index "chart" using "solves":(floor_(column("stepping"))) \
         with linespoints ls 2 title "load stepping", \
     data index "chart" using "solves":(floor_(column("search"))) \
         with linespoints ls 3 title "line search", \
     data index "chart" using "solves":(floor_(column("start"))) \
         with linespoints ls 4 title "better start", \
     data index "chart" using "solves":(floor_(column("cubic"))) \
         with linespoints ls 5 title "cubic law", \
     data index "chart_reasons" using (1):"linear" with points pt 6 ps 1.6 \
         lw 1.5 lc rgb "black" title "linear law"
