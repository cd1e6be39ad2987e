# cures.gp - iterations of each cure against the load, and against the step of
# the boundary; crosses in the grey band: the cure failed.
# Reads   data  tables load_cures, step_cures
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,470 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
array Name[5] = ["plain", "stepping", "search", "start", "cubic"]
array Style[5] = [1, 5, 3, 4, 2] # the cubic law is orange
array Point[5] = [6, 11, 9, 13, 5] # plain Newton: rings, seen under the rest
array Size[5] = [1.1, 0.5, 0.5, 0.5, 0.5]
array Colour[5] = ["#0072B2", "#E69F00", "#009E73", "#CC79A7", "#D55E00"]
set logscale xy
set xrange [0.027:37]
set yrange [1.7:4000]
set ytics (2, 5, 10, 20, 50, 100, 200, 500)
unset mytics
set object 1 rectangle from graph 0, first 620 to graph 1, graph 1 back \
    fc rgb "#EEEEEE" fs solid noborder
set format x "%g"
unset key
cost(k) = strcol(Name[k]) eq "OK" ? column(Name[k]."_iterations") : NaN
level(k) = k == 1 ? 2800 : k == 3 ? 1650 : 970
lost(k) = strcol(Name[k]) ne "OK" ? level(k) : NaN
set multiplot layout 1,2 margins 0.1,0.825,0.15,0.965 spacing 0.075,0
do for [panel = 1:2] {
    table = word("load_cures step_cures", panel)
    set xlabel (panel == 1 ? "load -p / (2μ + λ)" : \
        "push Δg / h of ten elements")
    set ylabel (panel == 1 ? "linear systems until converged" : "") offset 1,0
    if (panel == 2) {
        set label 4 "plain Newton" at 42, level(1) left tc rgb Colour[1]
        set label 5 "line search" at 42, level(3) tc rgb Colour[3]
        set label 6 "linear lift" at 42, level(4) tc rgb Colour[4]
        set label 7 "load stepping" at 42, 400 left tc rgb Colour[2]
        set label 8 "cubic law" at 42, 20 left tc rgb Colour[5]
        set label 1 ""
        set arrow 2 from 10, 1.7 to 10, 4000 nohead ls 8
        set label 2 "Δg = 1" at 9, 2.4 right boxed
    } else {
        set label 1 "better start" at 0.12, 3 tc rgb Colour[4] boxed
        set label 4 "plain Newton" at 0.85, level(1) right tc rgb Colour[1]
        set label 5 "line search" at 2, 3.8 tc rgb Colour[3] boxed
        set label 7 "load stepping" at 0.75, 16 right tc rgb Colour[2] boxed
        set label 8 "cubic law" at 0.032, 8 tc rgb Colour[5] boxed
    }
    set label 3 "failed" at 0.032, level(4) textcolor rgb "#555555"
    set arrow 1 from 1, 1.7 to 1, 4000 nohead ls 8
    plot for [k = 1:5] data index table using "x":(cost(k)) \
             with linespoints ls Style[k] pt Point[k] ps Size[k], \
         for [k = 1:5] data index table using "x":(lost(k)) \
             with points pt 2 ps 0.6 lw 1.5 lc rgb Colour[k]
}
unset multiplot
