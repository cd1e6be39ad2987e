# sag.gp - what is missing of the sag at nu = 0.4999, and how large div u of a
# triangle is, for five ways to cut the square, against the unknowns; linear
# triangles go on to far finer meshes, where graded ones (m = 1.5) would hide
# behind them.
# Reads   data  tables sag, finer
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,780
set output out
array Name[5] = ["linear", "averaged", "criss-cross", "quadratic", "quadratic"]
array M[5] = [1, 1, 1, 1, 2]
set style line 7 lc rgb "#333333" lw 2 pt 4 ps 0.8 # in no other figure here
array Style[5] = [2, 4, 7, 1, 3]
free(n) = 2 * n * (n + 1) # unknowns of linear triangles
of(k, what) = strcol("element") eq Name[k] && column("m") == M[k] \
              ? column(what) : NaN
set multiplot layout 2,1 margins 0.125,0.975,0.075,0.985 spacing 0,0.1
set logscale xy
set grid noxtics
unset key
set label 1 "linear, graded or not" at 150, 0.23 tc ls 2
set label 2 "criss-cross" at 4600, 0.0135 tc ls 7
set label 3 "averaged" at 170, 0.079 tc ls 4
set label 4 "quadratic" at 11700, 0.0037 right tc ls 1
set label 5 "quadratic, m = 2" at 2800, 0.0023 right tc ls 3
set xrange [110:2e5]
set xlabel "unknowns"
set ylabel "missing sag, ν = 0.4999" offset 1
set yrange [5e-4:1]
set format "10^{%T}"
plot for [k = 1:5] data index "sag" using (column("unknowns")):(of(k, "missing_0.4999")) \
         with linespoints ls Style[k], \
     data index "finer" using (free(column("n"))):(of(1, "missing_0.4999")) \
         with linespoints ls 2
unset label
set label 1 "averaged" at 2500, 330 tc ls 4
set label 2 "linear, graded or not" at 7300, 13 tc ls 2
set label 3 "quadratic, m = 2" at 11100, 2.1 right tc ls 3
set label 4 "quadratic" at 11100, 0.68 right tc ls 1
set label 5 "criss-cross" at 150, 0.72 tc ls 7
set ylabel "size of ∇·u, relative to its limit" offset 1
set yrange [0.3:2000]
plot for [k = 1:5] data index "sag" using (column("unknowns")):(of(k, "div_0.4999")) \
         with linespoints ls Style[k], \
     data index "finer" using (free(column("n"))):(of(1, "div_0.4999")) \
         with linespoints ls 2
unset multiplot
