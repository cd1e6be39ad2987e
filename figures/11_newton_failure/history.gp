# history.gp - Newton's method after its first step into the wall: F and the
# residual, system by system: the lesson's own numbers.
# Reads   data  table history (k F residual)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 620,400
set output out
set logscale y
set logscale y2
set format y "10^{%T}"
set format y2 "10^{%T}"
set border 11 back ls 9
set y2tics
set xlabel "systems"
set ylabel "F"
set y2label "|residual| (N)"
plot reference index "history" using "k":"F" with lines lw 7 lc rgb "#DDDDDD" \
         notitle, \
     reference index "history" using "k":(abs(column("residual"))) axes x1y2 \
         with lines lw 7 lc rgb "#DDDDDD" notitle, \
     data index "history" using "k":"F" with linespoints ls 1 title "F (left)", \
     data index "history" using "k":(abs(column("residual"))) axes x1y2 \
         with linespoints ls 2 title "residual (right)"
