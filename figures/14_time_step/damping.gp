# damping.gp - energy of the linear bar in its first mode, in time; the number
# behind a name is its steps in a frame of 1/30 s.
# Expected: 1, and (1 + omega^2 dt^2)^-1 per step for backward Euler.
# Reads   data  tables damping, first_mode
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/damping.tsv"
if (!exists("out"))  out  = "figures/14_time_step/damping.svg"
load "figures/style.gp"
set terminal svg size 680,430 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
stats data index "first_mode" using "omega" nooutput
w = STATS_max
set rmargin at screen 0.70
set tmargin 2.6
unset key
set logscale y
set format y "10^{%T}"
set xrange [0:0.4]
set yrange [1e-4:2]
set xlabel "time (s)"
set ylabel "energy over energy at the start"
# a name at the end of its line; three runs lose nothing that can be seen
set style textbox opaque noborder margins 0.4,0.4
set label 1 "midpoint: 1; no visible loss either:\nsymplectic Euler: 64, BDF2: 16" at 0.393, 3.4 right tc ls 3
set label 4 "backward Euler: 256" at 0.407, 0.85 tc ls 1
set label 5 "backward Euler: 16" at 0.407, 0.063 tc ls 1
set label 6 "BDF2: 1" at 0.407, 4e-3 tc ls 4
set label 7 "backward Euler: 1" at 0.158, 1.7e-3 tc ls 1 front boxed
set label 9 "numbers: steps per frame\ndashed: backward\nEuler, expected" at 0.393, 8e-4 right front boxed
plot data index "damping" using "t":"midpoint_1" with linespoints ls 3, \
     data index "damping" using "t":"backward_256" with linespoints ls 1 pt 6, \
     data index "damping" using "t":"backward_16" with linespoints ls 1 pt 4, \
     data index "damping" using "t":"bdf2_1" with linespoints ls 4, \
     data index "damping" using "t":"backward_1" with linespoints ls 1, \
     (1 + (w / 30)**2)**(-30 * x) with lines ls 8, \
     (1 + (w / 480)**2)**(-480 * x) with lines ls 8, \
     (1 + (w / 7680)**2)**(-7680 * x) with lines ls 8
set output
