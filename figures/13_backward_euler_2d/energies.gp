# energies.gp - what backward Euler loses: energy, of a body that swings under
# gravity; angular momentum, of one that spins freely.
# Reads   data  tables energies, spin
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,440
set output out
set multiplot layout 1,2 margins 0.08,0.985,0.13,0.78 spacing 0.11,0
set key above left maxrows 4 samplen 3
set xlabel "t (s)"
set ylabel "energy (J)"
set xrange [0:1.5]
set yrange [-30:20]
set label 1 "total, exact: 0" at 1.48, 1.4 right font ",12"
plot data index "energies" using "t":"kinetic" with lines ls 3 \
         title "kinetic, Δt = 1/30 s", \
     "" index "energies" using "t":"total" with lines ls 1 \
         title "total, Δt = 1/30 s", \
     "" index "energies" using "t":"total_120" with lines ls 1 dt 4 \
         title "total, Δt = 1/120 s", \
     "" index "energies" using "t":"total_480" with lines ls 1 dt 3 \
         title "total, Δt = 1/480 s", \
     0 ls 8 notitle
set xlabel "Δt (s)"
set ylabel "angular momentum after 1 s / at the start"
unset label 1
set logscale x
set xrange [0.0015:0.045]
set yrange [0.45:1.02]
set xtics ("1/480" 1/480., "1/240" 1/240., "1/120" 1/120., "1/60" 1/60., \
           "1/30" 1/30.)
plot 1 / sqrt(1 + 72 * x) ls 8 title "(1 + 2 Δt ω^2 t)^{-1/2}, ω = 6 rad/s", \
     data index "spin" using "dt":"angular" with points ls 2 ps 1 \
         title "computed", \
     1 with lines lw 1 lc rgb "#999999" title "exact"
unset multiplot
