# cliff.gp - symplectic Euler of the square at 0.99 and 1.01 of its critical
# step: energy over the number of steps.
# Expected: bounded by (1 + 0.99) / (1 - 0.99); at 1.01 the growth of the
# fastest mode.
# Reads   data  tables cliff_below, cliff_above
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/cliff.tsv"
if (!exists("out"))  out  = "figures/14_time_step/cliff.svg"
load "figures/style.gp"
set terminal svg size 640,420 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
stats data index "cliff_above" using "k":"energy" nooutput
k_last = STATS_max_x
E_last = STATS_max_y
stats data index "cliff_above" using "growth" nooutput
growth = STATS_max
set logscale y
set format y "10^{%T}"
set xrange [0:300]
set yrange [0.3:2e8]
set xlabel "steps"
set ylabel "energy over energy at the start"
unset key
set label 1 "1 % above the critical step" at 34, 2e6 textcolor ls 2 front boxed
set label 2 sprintf("dashed: times %.3f per step, expected", growth) \
    at 34, 1.4e5 front boxed
set style textbox opaque noborder margins 0.4,0.4
set label 3 "1 % below" at 295, 32 right textcolor ls 1 front boxed
set label 4 "bound of the blue curve" at 295, 600 right textcolor ls 1 front boxed
plot data index "cliff_above" using "k":"energy" with lines ls 2, \
     E_last * growth**(x - k_last) with lines ls 8, \
     data index "cliff_below" using "k":"energy" with lines ls 1, \
     1.99 / 0.01 with lines ls 8 dt 4
set output
