# history.gp - Newton's method after its first step into the wall: F and the
# residual, system by system: the lesson's own numbers.
# Reads   data  table history (k F residual)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 620,400 enhanced font "Helvetica,14" \
    background rgb "white"
unset key
set output out
set style textbox opaque noborder margins 0.3,0.3
set logscale y
set logscale y2
set format y "10^{%T}"
set format y2 "10^{%T}"
set border 11 back ls 9
set y2tics
set xlabel "linear systems"
set label 1 "F" at 8, 5e-3 right tc ls 1
set label 3 "grey: reference" at 11.5, 3e-4 tc rgb "#777777" boxed
set label 2 "residual" at 5, 0.75 tc ls 2
set ylabel "F" textcolor ls 1
set y2label "|residual| (N/m²)" textcolor ls 2
plot reference index "history" using "k":"F" with lines lw 7 lc rgb "#DDDDDD", \
     reference index "history" using "k":(abs(column("residual"))) axes x1y2 \
         with lines lw 7 lc rgb "#DDDDDD", \
     data index "history" using "k":"F" with linespoints ls 1, \
     data index "history" using "k":(abs(column("residual"))) axes x1y2 \
         with linespoints ls 2
