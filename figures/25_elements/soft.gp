# soft.gp - what an error at the shared vertices costs at nu = 0.4999, in flops of
# one system, by each element, even (dashed) and graded; and how many fit
# into 1/30 s.
# Expected: linear triangles far above; graded meshes steeper than even ones.
# Reads   data  table runs
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,460
set output out
set style line 10 lc rgb "#005F43" lw 2 pt 8 ps 0.9
set style line 7 lc rgb "#333333" lw 2 pt 4 ps 0.8
array Name[4] = ["linear", "averaged", "criss-cross", "quadratic"]
array Style[4] = [2, 4, 7, 1]
# m = 1; 1.68, the least that does, of degree 1; and 2 and 3.36 of degree 2
of(name, low, high) = strcol("element") eq name && column("m") > low \
                      && column("m") < high ? column("error") : NaN
unset key
set logscale xy
set grid noxtics
set xrange [1.5e4:5e9]
set yrange [1e-4:0.6]
set format "10^{%T}"
set xlabel "flops of one system"
set ylabel "error at the shared vertices, relative, ν = 0.4999"
set label 1 "linear" at 5e6, 0.47 tc ls 2
set label 2 "averaged" at 4e8, 3.4e-3 tc ls 4
set label 3 "criss-cross" at 1.1e7, 1.7e-2 tc ls 7
set label 4 "quadratic" at 4e8, 2.1e-3 tc ls 1
set label 5 "averaged, graded" at 4e8, 6.4e-4 tc ls 4
set label 6 "quadratic, m = 2" at 4e8, 4e-4 tc ls 3
set label 7 "quadratic, m = 3.36" at 2.2e8, 2.4e-4 right tc ls 10
set label 11 "criss-cross, graded" at 1.9e7, 2e-3 right tc ls 7
set label 8 "dashed: even meshes" at 2e4, 3e-4
set label 9 "solid: graded" at 2e4, 1.9e-4
# 8 Gflop per second, the lowest rate of figures/speed, table elements
set arrow from 2.7e8, 1e-4 to 2.7e8, 0.6 nohead ls 8 back
set label 10 "1/30 s at 8 Gflop per second" at 2.1e8, 0.048 right
plot for [k = 1:4] data index "runs" using "flops":(of(Name[k], 0.9, 1.1)) \
         with linespoints ls Style[k] dt 2, \
     for [k = 1:3] "" index "runs" using "flops":(of(Name[k], 1.6, 1.8)) \
         with linespoints ls Style[k], \
     "" index "runs" using "flops":(of("quadratic", 1.9, 2.1)) \
         with linespoints ls 3, \
     "" index "runs" using "flops":(of("quadratic", 3, 4)) \
         with linespoints ls 10
