# particles.gp - error of particles and of finite elements against counted flops:
# a bar that hangs, and a block that swings, with 16 steps per cell.
# The number of cells stands beside the points.
# Reads   data  tables runs (body curve cells steps error flops reason),
#               per_cell (floor)
# Writes  out   SVG
if (!exists("data")) data = "build/data/work_precision/particles.tsv"
if (!exists("out"))  out  = "figures/work_precision/particles.svg"
load "figures/style.gp"
set terminal svg size 580,840
set output out
array Body[2] = ["bar", "per_cell"]
array Title[2] = ["a bar that hangs", "a block that swings"]
array Curve[7] = ["elements", "linear", "quadratic", "cubic", \
    "ten_linear", "ten_quadratic", "ten_cubic"]
array Color[7] = ["#000000", "#0072B2", "#D55E00", "#009E73", \
    "#0072B2", "#D55E00", "#009E73"]
array Dash[7] = [1, 1, 1, 1, 2, 2, 2]
array Point[7] = [7, 9, 5, 13, 8, 4, 12]
# the bar, and the block with 16 steps per cell
runs = sprintf("< awk -F'\t' '$0 == \"# runs\" { on = 1; next } NF == 0 { on = 0 } \
    on && ($1 == \"body\" || $8 == \"OK\" && ($1 == \"bar\" || \
        $1 == \"per_cell\" && $4 == 16 * $3))' '%s'", data)
of(b, k) = strcol("body") eq Body[int(b)] && strcol("curve") eq Curve[int(k)] ? \
    column("error") : NaN
# n beside the points: on the right of a curve (1), or on the left.  In the bar the
# cubic kernels have room for two, behind the end of the linear ones.
on_right(b, k) = b == 1 ? k == 3 || k == 6 : k == 2
beside(b, k) = strcol("body") eq "bar" && k == 4 && column("cells") < 64 ? \
    NaN : of(b, k)
cells(k) = (k == 1 && column("cells") == 4 ? "n = " : "").strcol("cells")
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
        set xrange [7e2:5e6]
        set yrange [5e-7:0.5]
        set label 1 "finite\nelements" at 1.3e3, 6e-5
        set label 2 "linear kernels" at 1.1e4, 4.5e-3 tc rgb Color[2]
        set label 3 "quadratic" at 2.5e5, 4.6e-6 tc rgb Color[3]
        set label 4 "cubic, n = 8 to 128" at 3.5e5, 1.8e-6 tc rgb Color[4]
        set label 5 "quadratic, ten grids" at 1.6e5, 6e-3 tc rgb Color[3]
        set label 7 "linear, ten grids" at 1.6e5, 0.32 tc rgb Color[2]
        set label 6 "cubic,\nten grids" at 1.1e6, 3.2e-4 tc rgb Color[4]
    } else {
        unset label
        set xrange [1e5:1e9]
        set yrange [1e-3:0.15]
        set label 1 "finite\nelements" at 1.3e5, 2.1e-2
        set label 2 "linear kernels" at 1.5e6, 4.3e-2 right tc rgb Color[2]
        set label 6 "inverts\non n = 16" at 1.15e7, 1.42e-2 tc rgb Color[2]
        set label 7 "quadratic" at 2.1e8, 5.2e-3 right tc rgb Color[3]
        set label 3 "cubic" at 7e7, 2.8e-2 tc rgb Color[4]
        set label 4 "known to" at 1.3e5, 1.45e-3
    }
    plot data index "per_cell" every ::0::0 using (1e5):(b == 1 ? 1e-9 : column("floor")):(1e9):(0) \
             with vectors nohead ls 8 dt 3 notitle, \
         for [k = 1:7] runs using "flops":(of(b, k)) \
             with linespoints lw 1.5 pt Point[k] ps 0.6 lc rgb Color[k] \
             dt Dash[k], \
         for [k = 1:7] runs using (on_right(b, k) ? NaN : column("flops")):(beside(b, k)):(cells(k)) \
             with labels right offset -0.7,-0.45 font ",11" tc rgb Color[k], \
         for [k = 1:7] runs using (on_right(b, k) ? column("flops") : NaN):(beside(b, k)):(cells(k)) \
             with labels left offset 0.7,0.45 font ",11" tc rgb Color[k]
}
unset multiplot
