# map.gp - the first step over dt and n: iterations where Newton's method
# converges, crosses where it does not, for the cubic law.  Line: the boundary moves
# sin dt = as many h = 2 / n as boundary_step has measured; dotted: by h, as
# predicted.
# Reads   data  tables map_notes, map_demand, boundary_step
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,720
set output out
limit(name, column) = system("awk -F'\t' '$0 == \"# ".name."\" { on = 1 } \
    NF == 0 { on = 0 } on && $1 == 16 { s = $".column." } END { print s }' '".data."'") + 0.0
ended(how) = strcol("reason") eq how ? column("n") : NaN
# where the number of iterations is another one than one step before: the boxes
# between have the same
was = row = 0
changed(x) = (k = column("iterations"), new = k != was || column("n") != row, \
    was = k, row = column("n"), new ? ended("OK") : NaN)
jump = limit("boundary_step", 2)
set logscale xy
set xrange [0.0018:1.5]
set yrange [2.9:46]
set ytics (4, 6, 8, 11, 16, 23, 32)
set xtics ("1/480" 1.0/480, "1/120" 1.0/120, \
    "1/30" 1.0/30, "1/10" 0.1, "1/3" 1.0/3, "1" 1)
unset mxtics
unset grid
unset key
set palette defined (3 "#E8F1F8", 5 "#9CC6E3", 8 "#2F7FB5", 21 "#08306B")
set cbrange [3:21]
unset colorbox
set multiplot layout 2,1 margins 0.10,0.98,0.09,0.95 spacing 0.07,0.13
do for [k = 1:2] {
    name = word("map_notes map_demand", k)
    set xlabel "Δt (s)"
    set ylabel "cells per side n"
    set label 1 (k == 1 ? "the notes' method" : \
        "projection on demand, line search") at graph 0, graph 1.06 font ",14"
    set arrow 1 from asin(jump * 2 / 38), 38 to asin(jump * 2 / 3.05), 3.05 \
        nohead lw 2 lc rgb "black" back
    set arrow 2 from asin(2.0 / 38), 38 to asin(2.0 / 3.05), 3.05 \
        nohead lw 1 dt 3 lc rgb "black" back
    set label 2 (k == 1 ? sprintf("measured: Δg = %.2f h", jump) : "") at 0.5, 3.3 right front
    set label 5 (k == 1 ? "predicted: Δg = h" : "") at 0.19, 13.3 left front \
        font ",13"
    if (k == 2) { unset arrow 2 }
    set label 3 (k == 1 ? "blows up or wanders" : "goes on, in up to 21") \
        at 1.4, 41 right font ",13" \
        textcolor rgb (k == 1 ? "#D55E00" : "#08306B") front
    set label 4 (k == 1 ? "converges, in so many iterations" : "") at 0.002, 41 \
        font ",13" textcolor rgb "#2F7FB5" front
    plot data index name using "dt":(ended("OK")):"iterations" \
             with points pt 5 ps 1.25 lc palette, \
         data index name using "dt":(changed(0)): \
             (sprintf("%d", column("iterations"))): \
             (column("iterations") < 8 ? 0 : 0xFFFFFF) with labels \
             font ",11" textcolor rgb variable, \
         data index name using "dt":(ended("fails")) \
             with points pt 2 ps 0.6 lw 1.5 lc rgb "#D55E00", \
         data index name using "dt":(ended("INVERTED")) \
             with points pt 1 ps 0.8 lw 2 lc rgb "#AA3377"
}
unset multiplot
