# growth.gp - flops and memory of three storages against n, counted.
# Expected: slopes 6, 4, 3 of the flops; 4, 3 and 2 (times log n) of the entries.
# Reads   data  tables growth, crossovers
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,430
set output out
stats data index "crossovers" using "flops" nooutput name "F"
stats data index "crossovers" using "entries" nooutput name "E"
of(k) = strcol("storage") eq k ? column("n") : NaN
set datafile missing "-"
set multiplot layout 1,2 margins 0.085,0.985,0.13,0.85 spacing 0.105,0
set logscale xy
set format y "10^{%T}"
set xtics (2, 4, 8, 16, 32, 64, 128, 256)
set xrange [3:560]
set xlabel "squares per side n"
set ylabel "flops to factor K"
set yrange [1e3:1e15]
set label 1 "n^6" at 290,7.5e14 left font ",12"
set label 2 "n^4" at 290,3.4e10 left font ",12"
set label 3 "n^3" at 290,2.5e9 left font ",12"
set arrow 1 from F_max, 1e3 to F_max, 1.6e6 nohead ls 8
set label 4 sprintf("%d", F_max) at F_max * 1.08, 3e3 left font ",12"
set key maxrows 2 samplen 2
plot data index "growth" using (of("full")):"flops" with linespoints ls 2 \
         title "all of the matrix", \
     data index "growth" using (of("band")):"flops" with linespoints ls 1 \
         title "its band", \
     data index "growth" using (of("dissection")):"flops" \
         with linespoints ls 3 title "nested dissection"
set ylabel "numbers stored of L"
set yrange [1e2:1e11]
set label 1 "n^4" at 290,1.7e10
set label 2 "n^3" at 290,6.7e7
set label 3 "n^2 log n" at 290,1.0e7
set arrow 1 from E_max, 1e2 to E_max, 3e4 nohead ls 8
set label 4 sprintf("%d", E_max) at E_max * 1.08, 2.5e2 left font ",12"
plot data index "growth" using (of("full")):"entries" with linespoints ls 2 \
         notitle, \
     data index "growth" using (of("band")):"entries" with linespoints ls 1 \
         notitle, \
     data index "growth" using (of("dissection")):"entries" \
         with linespoints ls 3 notitle
unset multiplot
