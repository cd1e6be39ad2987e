# cliff.gp - symplectic Euler of the square at 0.99 and 1.01 of its critical
# step: energy over the number of steps.
# Expected: bounded by (1 + 0.99) / (1 - 0.99); at 1.01 the growth of the
# fastest mode.
# Reads   data  tables cliff_below, cliff_above
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/cliff.tsv"
if (!exists("out"))  out  = "figures/14_time_step/cliff.svg"
load "figures/style.gp"
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
plot data index "cliff_above" using "k":"energy" with lines ls 2 \
         title "1.01 of the critical step", \
     E_last * growth**(x - k_last) with lines ls 8 \
         title sprintf("expected: times %.3f per step", growth), \
     data index "cliff_below" using "k":"energy" with lines ls 1 \
         title "0.99 of the critical step", \
     1.99 / 0.01 with lines ls 8 dt 4 title "bound at 0.99"
set output
