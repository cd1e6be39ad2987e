# history.gp - the residual of CG after each iteration: the lesson's own numbers.
# Reads   data  table history (k residual)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 560,400
set output out
unset key
set logscale y
set format y "10^{%T}"
set xlabel "iterations"
set ylabel "|r| / |b|" offset 1
plot reference index "history" using "k":"residual" with lines lw 7 \
         lc rgb "#DDDDDD", \
     data index "history" using "k":"residual" with linespoints ls 6
