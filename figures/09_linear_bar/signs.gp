# signs.gp - the modulus with the right and with the printed sign, and the
# displacements of a pulled bar.
# Reads   data  tables moduli, end_loads, printed_modulus
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,400 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3

set multiplot layout 1,2 margins 0.085,0.985,0.165,0.965 spacing 0.125,0
unset key
set label 4 "2μ + λ" at 0.32, 2.6 right tc ls 1
set label 5 "2μ − λ, as printed" at 0.015, -0.6 tc ls 2

set xrange [0:0.5]
set yrange [-4:6]
set xtics 0.1
set ytics 2
set xlabel "Poisson's ratio ν"
set ylabel "modulus / E" offset 0.5
set arrow 1 from 1./3, -4 to 1./3, 6 nohead ls 8
set label 1 "yellow: K is\nnegative definite" at 0.015, -2.6 tc rgb "#555555"
set label 2 "ν = 1/3" at 0.325, 5.3 right
set grid noxtics
set object 1 rectangle from 1./3, -4 to 0.5, 0 behind \
    fc rgb "#F0E442" fs transparent solid 0.30 noborder
plot data index "moduli" using "nu":"modulus" with lines ls 1, \
     data index "moduli" using "nu":"printed" with lines ls 2 dt 4, \
     0 ls 9

unset arrow 1
unset label 1
unset label 2
set grid xtics
set label 4 "printed modulus, ν = 0.3" at 0.05, 0.45 left tc ls 2 boxed
set label 5 "correct" at 0.5, 0.15 tc ls 1 boxed
set label 6 "printed sign of the end load" at 0.98, -0.15 right tc ls 3 boxed
unset object 1
set xrange [0:1]
set yrange [-0.2:0.6]
set xtics 0.5
set ytics 0.1
set xlabel "X (m)"
set ylabel "u (m), pulled by 100 N/m²" offset 0.5
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
