# growth.gp - flops and memory of three storages against n, counted.
# Expected: slopes 6, 4, 3 of the flops; 4, 3 and 2 (times log n) of the entries.
# Reads   data  tables growth, crossovers
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,800
set output out
stats data index "crossovers" using "flops" nooutput name "F"
stats data index "crossovers" using "entries" nooutput name "E"
of(k) = strcol("storage") eq k ? column("n") : NaN
set datafile missing "-"
set multiplot layout 2,1 margins 0.125,0.975,0.075,0.985 spacing 0,0.1
set logscale xy
set grid noxtics
set format y "10^{%T}"
set xtics (2, 4, 8, 16, 32, 64, 128, 256)
set xrange [3:320]
set xlabel "squares per side n"
set ylabel "flops to factor K"
set yrange [1e3:1e15]
set label 1 "full matrix, n^6" at 80,1e13 right tc ls 2
set label 2 "band, n^4" at 80,1e9 right tc ls 1
set label 3 "dissection, n^3" at 290,1e7 right tc ls 3
set arrow 1 from F_max, 1e3 to F_max, 1.6e6 nohead ls 8
set label 4 sprintf("%d", F_max) at F_max * 1.08, 3e3 left
unset key
plot data index "growth" using (of("full")):"flops" with linespoints ls 2, \
     data index "growth" using (of("band")):"flops" with linespoints ls 1, \
     data index "growth" using (of("dissection")):"flops" \
         with linespoints ls 3
set ylabel "numbers stored for L"
set yrange [1e2:1e11]
set ytics 1e2,100
set label 1 "full matrix, n^4" at 80,1e9 right tc ls 2
set label 2 "band, n^3" at 290,6e8 right tc ls 1
set label 3 "dissection, n^2·log n" at 290,9e4 right tc ls 3
set arrow 1 from E_max, 1e2 to E_max, 3e4 nohead ls 8
set label 4 sprintf("%d", E_max) at E_max * 1.08, 2.5e2 left
plot data index "growth" using (of("full")):"entries" with linespoints ls 2, \
     data index "growth" using (of("band")):"entries" with linespoints ls 1, \
     data index "growth" using (of("dissection")):"entries" \
         with linespoints ls 3
unset multiplot
