# sag.gp - what is missing of the sag at nu = 0.4999, and how large div u of a
# triangle is, for six ways to cut the square.
# Reads   data  table sag
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 800,400
set output out
array Name[6] = ["linear", "linear", "averaged", "criss-cross", "quadratic", \
                 "quadratic"]
array M[6] = [1, 1.5, 1, 1, 1, 2]
array Text[6] = ["linear", "linear, m = 1.5", "averaged", "criss-cross", \
                 "quadratic", "quadratic, m = 2"]
array Style[6] = [2, 5, 4, 6, 1, 3]
of(k, what) = strcol("element") eq Name[k] && column("m") == M[k] \
              ? column(what) : NaN
set multiplot layout 1,2 margins 0.09,0.99,0.145,0.96 spacing 0.115,0
set logscale xy
unset key
set label 1 "linear, graded or not" at 8.2, 0.23
set label 2 "averaged" at 34.5, 0.0165 tc ls 4
set label 3 "criss-cross" at 34.5, 0.0092 tc ls 6
set label 4 "quadratic" at 34.5, 0.0052 tc ls 1
set label 5 "quadratic, m = 2" at 34.5, 0.0012 tc ls 3
set xrange [7:82]
set xtics (8, 16, 32)
set xlabel "squares per side n"
set ylabel "missing sag, ν = 0.4999" offset 1
set yrange [5e-4:1]
set format y "10^{%T}"
plot for [k = 1:6] data index "sag" using "n":(of(k, "missing_0.4999")) \
         with linespoints ls Style[k]
unset label
set label 1 "averaged" at 34.5, 330 tc ls 4
set label 2 "linear," at 34.5, 22 tc ls 2
set label 3 "with m = 1.5" at 34.5, 12 tc ls 5
set label 4 "quadratic, m = 2" at 34.5, 2.2 tc ls 3
set label 5 "quadratic" at 34.5, 1.2 tc ls 1
set label 6 "criss-cross" at 34.5, 0.65 tc ls 6
set ylabel "size of div u, relative to its limit" offset 1
set yrange [0.5:2000]
plot for [k = 1:6] data index "sag" using "n":(of(k, "div_0.4999")) \
         with linespoints ls Style[k]
unset multiplot
