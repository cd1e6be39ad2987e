# particles.gp - error of particles and of finite elements against counted flops:
# a bar that hangs, and a block that swings.
# Reads   data  tables runs (body curve error flops reason), per_cell (floor)
# Writes  out   SVG
if (!exists("data")) data = "build/data/work_precision/particles.tsv"
if (!exists("out"))  out  = "figures/work_precision/particles.svg"
load "figures/style.gp"
set terminal svg size 580,840
set output out
array Body[2] = ["bar", "block"]
array Title[2] = ["a bar that hangs", "a block that swings"]
array Curve[10] = ["elements", "linear", "quadratic", "cubic", "FLIP", \
    "ten_linear", "ten_quadratic", "ten_cubic", "implicit", "implicit_elements"]
array Color[10] = ["#000000", "#0072B2", "#D55E00", "#009E73", "#E69F00", \
    "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#777777"]
array Dash[10] = [1, 1, 1, 1, 1, 2, 2, 2, 1, 1]
array Point[10] = [7, 9, 5, 13, 11, 8, 4, 12, 10, 6]
of(b, k) = strcol("body") eq Body[int(b)] && \
    strcol("curve") eq Curve[int(k)] && strcol("reason") eq "OK" ? \
        column("error") : NaN
set multiplot
set logscale xy
set grid noxtics ytics
set format xy "10^{%T}"
set lmargin at screen 0.13
set rmargin at screen 0.97
unset key
do for [b = 1:2] {
    set title Title[b]
    set ylabel "relative error of u"
    set xlabel b == 2 ? "flops counted" : ""
    set tmargin at screen b == 1 ? 0.955 : 0.47
    set bmargin at screen b == 1 ? 0.56 : 0.07
    if (b == 1) {
        set xrange [1e3:5e6]
        set yrange [5e-7:0.5]
        set label 1 "finite\nelements" at 1.3e3, 6e-5
        set label 2 "linear kernels" at 1.1e4, 4.5e-3 tc rgb Color[2]
        set label 3 "quadratic" at 2.3e5, 6.5e-6 tc rgb Color[3]
        set label 4 "cubic" at 3.5e5, 1.8e-6 tc rgb Color[4]
        set label 5 "quadratic, ten grids" at 1.6e5, 3.6e-3 tc rgb Color[3]
        set label 7 "linear, ten grids" at 1.6e5, 0.32 tc rgb Color[2]
        set label 6 "cubic,\nten grids" at 1.1e6, 3.2e-4 tc rgb Color[4]
    } else {
        unset label
        set xrange [3e4:6e8]
        set yrange [1e-3:0.3]
        set label 1 "finite\nelements" at 1.2e5, 7e-3
        set label 2 "elements, implicit" at 1.9e5, 0.16 tc rgb "#555555"
        set label 3 "quadratic, FLIP" at 8.5e5, 0.122 tc rgb Color[5]
        set label 4 "quadratic, implicit" at 9e6, 0.082 tc rgb Color[9]
        set label 5 "quadratic" at 7e5, 0.036 right tc rgb Color[3]
        set label 6 "cubic" at 1e8, 7.7e-3 tc rgb Color[4]
        set label 7 "known to" at 4e4, 1.45e-3
        set label 8 "points: n = 4, 8, 16, of elements also 32" at 4.5e8, 2.2e-3 right \
            tc rgb "#555555"
    }
    plot data index "per_cell" every ::0::0 using (3e4):(b == 1 ? 1e-9 : column("floor")):(6e8):(0) \
             with vectors nohead ls 8 dt 3 notitle, \
         for [k = 1:10] data index "runs" using "flops":(of(b, k)) \
             with linespoints lw 1.5 pt Point[k] ps 0.6 lc rgb Color[k] \
             dt Dash[k]
}
unset multiplot
