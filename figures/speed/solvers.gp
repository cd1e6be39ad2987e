# solvers.gp - a whole step by the band, by nested dissection, and by CHOLMOD
# where there is one; and one solve with their factors, relative to dissection.
# Expected: slopes 4 and 3 of the step for large n; a solve in single precision
# with its refinements costs more, and a band more from n = 36 on.
# Reads   data  tables solvers (solver n solve_ms step_ms), crossover, machine;
#               from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,820
set output out
array Name[4] = ["band", "dissection", "single", "cholmod"]
array Style[4] = [1, 3, 6, 4]
of(k) = strcol("solver") eq Name[int(k)] ? column("n") : NaN
cholmod = system("grep -c '^cholmod\t' '".data."'") > 0
stats data index "crossover" using "step_n" nooutput name "C"
stats data index "solvers" using (strcol("solver") eq "dissection" ? \
      column("solve_ms") : NaN) nooutput name "S"
set datafile missing "-"
# Each solver has a row for each n, in one order; dissection's come second.
array Base[S_records]
stats data index "solvers" using (strcol("solver") eq "dissection" ? \
      (Base[int($0) % S_records + 1] = column("solve_ms")) : NaN) nooutput
over(k) = strcol("solver") eq Name[int(k)] ? \
          column("solve_ms") / Base[int($0) % S_records + 1] : NaN

set multiplot layout 2,1 margins 0.11,0.98,0.095,0.985 spacing 0,0.1
unset key
set label 9 machine(data) at screen 0.01,0.014 left textcolor rgb "#555555"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128, 256)
set xrange [7:300]
set yrange [1e-2:2e3]
set xlabel "squares per side n"
set ylabel "whole time step (ms)"
set arrow 1 from C_max, graph 0 to C_max, graph 0.45 nohead ls 8
set label 1 "1/30 s" at 8.5,52 left
set label 2 "band" at 165,400 right tc ls 1
set label 3 "dissection" at 105,4.2 left tc ls 3
set label 4 (cholmod ? "CHOLMOD" : "") at 8.5,0.45 left tc ls 4
set label 5 sprintf("dissection is\nfaster from\nn = %d on", C_max) \
    at C_max * 1.12,0.065 left
plot for [k in cholmod ? "1 2 4" : "1 2"] data index "solvers" \
         using (of(k)):"step_ms" with linespoints ls Style[int(k)], \
     1000.0 / 30.0 with lines ls 8
unset label
unset arrow
unset logscale y
set format y "%g"
set grid noxtics
set yrange [0:4.5]
set ytics 1
set ylabel "solve with given factors, over dissection"
set label 1 "single precision,\nrefined" at 14,2.5 left tc ls 6
set label 2 "band" at 190,3.4 right tc ls 1
set label 3 "dissection" at 280,0.74 right tc ls 3
set label 4 (cholmod ? "CHOLMOD" : "") at 17,3.75 left tc ls 4
plot for [k in cholmod ? "1 3 4" : "1 3"] data index "solvers" \
         using (of(k)):(over(k)) with linespoints ls Style[int(k)], \
     1 with lines ls 3
unset multiplot
