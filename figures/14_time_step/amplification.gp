# amplification.gp - what one step makes of the amplitude of a mode: the
# spectral radius of the four integrators over omega dt.
# Expected: 1/sqrt(1 + z^2) (backward Euler), 1 (midpoint), 1 up to z = 2 and
# z^2/2 - 1 + z sqrt(z^2/4 - 1) beyond (symplectic Euler).
# Reads   data  tables amplification, bar_modes
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/amplification.tsv"
if (!exists("out"))  out  = "figures/14_time_step/amplification.svg"
load "figures/style.gp"
set terminal svg size 640,420 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
unset key

array Mode[3]
do for [k = 1:3] {
    stats data index "bar_modes" using "omega" every ::k-1::k-1 nooutput
    Mode[k] = STATS_max / 30.0
}
set logscale x
set xrange [0.01:100]
set yrange [0:1.6]
set xlabel "ω Δt"
set ylabel "growth of the amplitude per step\n(spectral radius)"
set arrow 1 from 2, 0 to 2, 1.6 nohead ls 8
set style textbox opaque noborder margins 0.4,0.4
set label 1 "ω Δt = 2" at 1.7, 1.48 right front boxed
set label 3 "symplectic Euler\ngrows beyond 2" at 2.4, 1.48 tc ls 2 front boxed
set label 4 "midpoint" at 26, 1.08 tc ls 3 front boxed
set label 8 "midpoint, and symplectic Euler up to 2" at 0.012, 1.08 \
    tc ls 3 front boxed
set label 5 "BDF2" at 3.4, 0.68 tc ls 4 front boxed
set label 6 "backward Euler" at 0.55, 0.66 right tc ls 1 front boxed
set label 7 "dashed: expected" at 0.012, 0.09 front boxed
set label 2 "bar, modes 1, 3, 5\nat 1/30 s" at 7.6, 0.56 left front boxed
plot data index "amplification" using "w_dt":"symplectic" with lines ls 2, \
     data index "amplification" using "w_dt":"backward" with lines ls 1, \
     data index "amplification" using "w_dt":"midpoint" with lines ls 3, \
     data index "amplification" using "w_dt":"bdf2" with lines ls 4, \
     1 / sqrt(1 + x**2) with lines ls 8, \
     data index "bar_modes" using (column("omega") / 30):"backward" \
         with points ls 1 ps 1.1, \
     data index "bar_modes" using (column("omega") / 30):"bdf2" \
         with points ls 4 ps 1.1
set output
