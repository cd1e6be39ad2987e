# scene.gp - a square that hangs from its left side at nu = 0.4999: linear
# triangles on two meshes, over where it ought to hang.
# Reads   data  tables lines, missing
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,340
set output out
array Body[2] = ["coarse", "fine"]
array Cells[2] = ["8 x 8", "32 x 32"]
lost(b) = system("awk -F'\t' '$0 == \"# missing\" { on = 1 } \
    on && $1 == \"".b."\" { printf \"%.0f\", 100 * $3 }' '".data."'")
times = 45
of(b, l, v) = strcol("body") eq b && strcol("path") eq l ? v : NaN
px(b, l) = of(b, l, column("X") + times * column("u_x"))
py(b, l) = of(b, l, column("Y") + times * column("u_y"))
array Path[3] = ["rows", "columns", "sides"]
set multiplot layout 1,2 margins 0.03,0.99,0.03,0.9 spacing 0.03,0
unset key
unset border
unset tics
unset grid
set size ratio -1
set xrange [-1.2:1.2]
set yrange [-1.78:1.05]
set arrow 1 from -1, -1 to -1, 1 nohead lw 4 lc rgb "#333333" front
set label 2 "held" at -1.13, 0 center rotate by 90
do for [k = 1:2] {
    set label 1 Cells[k]." cells: ".lost(Body[k])." % of the sag is missing" \
        at 0, 1.13 center
    set label 3 "where it ought to hang" at 0.1, -1.7 center tc rgb "#777777"
    plot data index "lines" using (px("limit", "sides")):(py("limit", "sides")) \
             with lines lw 4 lc rgb "#AAAAAA", \
         for [l = 1:3] "" index "lines" \
             using (px(Body[k], Path[l])):(py(Body[k], Path[l])) \
             with lines lw (l < 3 ? 0.6 : 2) lc rgb "#D55E00"
}
unset multiplot
