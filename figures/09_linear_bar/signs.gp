# signs.gp - the modulus with the right and with the printed sign, and the
# displacements of a pulled bar.
# Reads   data  tables moduli, end_loads, printed_modulus
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,360 enhanced font "Helvetica,13" \
    background rgb "white"
set output out

set multiplot layout 1,2 margins 0.075,0.985,0.16,0.96 spacing 0.11,0
unset key
set label 4 "2μ + λ" at 0.32, 2.3 right tc ls 1
set label 5 "2μ − λ, as printed" at 0.02, -0.45 tc ls 2

set xrange [0:0.5]
set yrange [-4:6]
set xtics 0.1
set ytics 2
set xlabel "Poisson's ratio ν"
set ylabel "modulus / E" offset 0.5
set arrow 1 from 1./3, -4 to 1./3, 6 nohead ls 8
set label 1 "no stiffness" at 0.02, -3.1 tc rgb "#555555" font ",12"
set label 2 "2μ − λ = 0 at ν = 1/3:" at 0.02, -2.5 tc rgb "#555555" font ",12"
set label 3 "K negative\ndefinite" at 0.342, -3.0 tc rgb "#555555" font ",12"
set object 1 rectangle from 1./3, -4 to 0.5, 0 behind \
    fc rgb "#F0E442" fs transparent solid 0.30 noborder
plot data index "moduli" using "nu":"modulus" with lines ls 1, \
     data index "moduli" using "nu":"printed" with lines ls 2 dt 4, \
     0 ls 9

unset arrow 1
unset label 1
unset label 2
unset label 3
set label 4 "printed modulus, ν = 0.3" at 0.6, 0.42 right tc ls 2
set label 5 "correct" at 0.6, 0.085 tc ls 1
set label 6 "printed sign of the end load" at 0.98, -0.15 right tc ls 3
unset object 1
set xrange [0:1]
set yrange [-0.2:0.6]
set xtics 0.25
set ytics 0.1
set xlabel "X (m)"
set ylabel "u (m) with +100 N/m² at X = 1" offset 0.5
stats data index "printed_modulus" using "u_printed" every ::0::0 \
    name "SOFT" nooutput
plot SOFT_max * x with lines ls 2 dt 4, \
     data index "end_loads" using (strcol("end") eq "right" ? column("X") : NaN):"u" \
         with linespoints ls 1, \
     data index "end_loads" \
         using (strcol("end") eq "right" ? column("X") : NaN):"u_printed" \
         with linespoints ls 3
unset multiplot
set output
