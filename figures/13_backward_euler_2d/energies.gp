# energies.gp - what backward Euler loses: energy, of a body that swings under
# gravity; angular momentum, of one that spins freely.
# Reads   data  tables energies, spin
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,860 enhanced font "Helvetica,19" \
    background rgb "white"
set output out
set multiplot layout 2,1 margins 0.16,0.97,0.095,0.985 spacing 0,0.12
unset key
set xlabel "t (s)"
set ylabel "energy (J)"
set xrange [0:1.5]
set yrange [-30:20]
set style textbox opaque noborder margins 0.4,0.4
set label 1 "total, exact: 0" at 1.48, 2.9 right front boxed
set label 2 "kinetic, Δt = 1/30 s" at 0.22, 14 tc ls 3 front boxed
set label 3 "total, Δt = 1/480 s" at 0.66, -2.7 tc ls 1 front boxed
set label 4 "1/120 s" at 0.81, -12.7 tc ls 1 front boxed
set label 5 "1/30 s" at 0.61, -21.2 tc ls 1 front boxed
plot data index "energies" using "t":"kinetic" with lines ls 3, \
     "" index "energies" using "t":"total" with lines ls 1, \
     "" index "energies" using "t":"total_120" with lines ls 1 dt 4, \
     "" index "energies" using "t":"total_480" with lines ls 1 dt 3, \
     0 ls 8
set xlabel "Δt (s)"
set ylabel "angular momentum left"
unset label
set label 1 "predicted for 6 rad/s:\n(1 + 2 Δt ω^2 t)^{-1/2}" at 0.0017, 0.72 front boxed
set label 2 "computed" at 0.0188, 0.73 left tc ls 2 front boxed
set label 3 "exact" at 0.04, 0.965 right front boxed
set logscale x
set xrange [0.0015:0.045]
set yrange [0.45:1.02]
set xtics ("1/480" 1/480., "1/240" 1/240., "1/120" 1/120., "1/60" 1/60., \
           "1/30" 1/30.)
plot 1 / sqrt(1 + 72 * x) ls 8, \
     data index "spin" using "dt":"angular" with points ls 2 ps 1, \
     1 with lines lw 1 lc rgb "#999999"
unset multiplot
