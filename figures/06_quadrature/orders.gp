# orders.gp - error of the total load against element length, for a load that
# is smooth, has a kink, jumps.
# Expected slopes: 2, 2, 4; 2, 2, 2; 1, 1, 1.
#
# Reads   data  tables load_smooth, load_kink, load_step (and _orders)
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 860,460 enhanced font "Helvetica,18"
set output out

set logscale xy
set xrange [5.5e-3:0.36]
set format y "10^{%T}"
set format x "%g"
set xtics ("1/128" 1./128, "1/32" 1./32, "1/8" 1./8)
set xlabel "element length h"
unset key

array Rule[3] = ["midpoint", "trapezoid", "gauss2"]
array Table[3] = ["load_smooth", "load_kink", "load_step"]
array Title[3] = ["smooth load", "kink: f = |x - 1/3|", "f jumps at 1/3"]

set multiplot layout 1,3 margins 0.125,0.985,0.185,0.90 spacing 0.035,0
do for [panel = 1:3] {
    if (panel == 1) {
        set ylabel "|error| of the total load"
        set yrange [1e-11:1]
    } else {
        unset ylabel
        set format y ""
    }
    set title Title[panel] offset 0,-0.5
    slope = panel == 3 ? 1 : 2
    top = panel == 3 ? 0.62 : panel == 2 ? 0.6 : 1.6
    set label 1 sprintf("slope %d", slope) \
        at 0.02, top * 0.02**slope * (panel == 3 ? 2.5 : 8) right boxed
    set label 2 panel == 1 ? "slope 4" : "" at 0.035, 1e-9 boxed
    if (panel == 1) {
        set label 3 "trapezoidal" at 0.2, 1.2e-1 right textcolor ls 2 boxed
        set label 4 "midpoint" at 0.03, 3e-5 left textcolor ls 1 boxed
        set label 5 "Gauss" at 0.04, 2e-6 right textcolor ls 3 boxed
    }
    if (panel == 2) {
        set label 3 "trapezoidal" at 0.2, 0.45 right textcolor ls 2 boxed
        set label 4 "midpoint" at 0.2, 0.1 right textcolor ls 1 boxed
        set label 5 "Gauss" at 0.012, 1.5e-7 left textcolor ls 3 boxed
    }
    if (panel == 3) {
        unset label 3
        set label 4 "midpoint" at 0.2, 0.4 right textcolor ls 1 boxed
        set label 5 "Gauss and trapezoidal" at 0.008, 4e-4 left textcolor ls 3 boxed
    }
    plot for [r = 1:3] data index Table[panel] \
             using "h":(abs(column(Rule[r]))) with linespoints ls r, \
         top * x**slope ls 8, (panel == 1 ? 0.005 : NaN) * x**4 ls 8
}
unset multiplot
