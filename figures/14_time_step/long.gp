# long.gp - the energy of the square over a hundred thousand steps, of each
# method the least and the largest in blocks of steps.
# Expected: about 1 (midpoint), bounded (symplectic Euler), to 0 (the others).
# Reads   data  table long
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/long.tsv"
if (!exists("out"))  out  = "figures/14_time_step/long.svg"
load "figures/style.gp"
set terminal svg size 640,420 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
array Key[4] = ["symplectic", "backward", "midpoint", "bdf2"]
array Style[4] = [2, 1, 3, 4]
unset key
set style textbox opaque noborder margins 0.6,0.6
set label 3 "symplectic Euler" at 1e3, 1.18 center front
set label 4 "midpoint" at 1e4, 1 center tc ls 3 front boxed
set label 5 "BDF2" at 2.5e2, 0.43 left tc ls 4 front boxed
set label 6 "backward Euler" at 45, 0.18 left tc ls 1 front
set logscale x
set format x "10^{%T}"
set format y "%g"
set ytics 0.2
set xrange [30:1e5]
set yrange [0:1.5]
set xlabel "steps"
set ylabel "energy over that of the start"
only(m, y) = strcol("method") eq Key[m] ? column(y) : NaN
plot for [m = 1:4] data index "long" \
         using "steps":(only(m, "least")):(only(m, "most")) \
         with filledcurves ls Style[m] fs transparent solid 0.5, \
     for [m = 1:4] data index "long" using "steps":(only(m, "most")) \
         with lines ls Style[m] lw 1.5
set output
