# map.gp - the first step over dt and n: iterations where Newton's method
# converges, crosses where it does not.  Lines: the boundary moves sin dt =
# 0.95 h, h = 2 / n (predicted), or by what boundary_step measured.
# Reads   data  tables map_notes, map_notes_log, map_demand, map_lift_log,
#               boundary_step
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 880,660
set output out
limit(name, column) = system("awk -F'\t' '$0 == \"# ".name."\" { on = 1 } \
    NF == 0 { on = 0 } on { s = $".column." } END { print s }' '".data."'") + 0.0
ended(how) = strcol("reason") eq how ? column("n") : NaN
# n where the number of iterations is another one than one step before, and no line
# is near; of those from 10 on 12, 16 and 20
was = row = 0
changed(x) = (k = column("iterations"), new = k != was || column("n") != row, \
    was = k, row = column("n"), \
    over = sin(column("dt")) * column("n") / 2, \
    new && (over < 0.72 || over > 1.12) && (k < 10 || k == 12 || k == 16 || k == 20) ? ended("OK") : NaN)
array Limit[2] = [limit("boundary_step", 2), limit("boundary_step", 3)]
set logscale xy
set xrange [0.0018:1.15]
set yrange [3.3:39]
set ytics (4, 6, 8, 11, 16, 23, 32)
set xtics ("1/480" 1.0/480, "1/240" 1.0/240, "1/120" 1.0/120, "1/60" 1.0/60, \
    "1/30" 1.0/30, "1/10" 0.1, "1/3" 1.0/3, "1" 1)
unset mxtics
unset grid
unset key
set label 11 "converged; iterations where they change" at screen 0.09, 0.975 \
    point pt 5 ps 1.4 lc rgb "#9CC6E3" offset 1, 0
set label 12 "blows up or wanders" at screen 0.395, 0.975 point pt 2 ps 0.8 \
    lw 1.5 lc rgb "#D55E00" offset 1, 0
set label 13 "inverted" at screen 0.565, 0.975 point pt 1 ps 0.9 lw 2 \
    lc rgb "#AA3377" offset 1, 0
set label 14 "limit of Δg / h: measured" at screen 0.68, 0.975 offset 1, 0
set arrow 14 from screen 0.66, 0.975 to screen 0.685, 0.975 nohead lw 2 \
    lc rgb "black"
set label 15 "0.95" at screen 0.92, 0.975 offset 1, 0
set arrow 15 from screen 0.89, 0.975 to screen 0.92, 0.975 nohead lw 1.5 \
    dt 2 lc rgb "black"
set palette defined (3 "#E8F1F8", 5 "#9CC6E3", 8 "#2F7FB5", 14 "#08306B")
set cbrange [3:14]
unset colorbox
set multiplot layout 2,2 margins 0.075,0.98,0.09,0.90 spacing 0.07,0.14
do for [k = 1:4] {
    name = word("map_notes map_notes_log map_demand map_lift_log", k)
    set xlabel (k > 2 ? "Δt (s)" : "")
    set ylabel (k % 2 ? "squares per side n" : "")
    set label 1 (k == 1 ? "notes' Newton, cubic law" : k == 2 ? \
        "notes' Newton, log law" : k == 3 ? \
        "cubic law, projected on demand, line search" : \
        "log law, lifted start") at graph 0, graph 1.07
    l = Limit[2 - k % 2]
    set arrow 1 from asin(l * 2 / 39), 39 to asin(l * 2 / 3.3), 3.3 \
        nohead lw 2 lc rgb "black" front
    set arrow 2 from asin(0.95 * 2 / 39), 39 to asin(0.95 * 2 / 3.3), 3.3 \
        nohead lw 1.5 dt 2 lc rgb "black" front
    plot data index name using "dt":(ended("OK")):"iterations" \
             with points pt 5 ps 1.05 lc palette, \
         data index name using "dt":(changed(0)): \
             (sprintf("%d", column("iterations"))): \
             (column("iterations") < 8 ? 0 : 0xFFFFFF) with labels \
             font ",12" textcolor rgb variable, \
         data index name using "dt":(ended("fails")) \
             with points pt 2 ps 0.6 lw 1.5 lc rgb "#D55E00", \
         data index name using "dt":(ended("INVERTED")) \
             with points pt 1 ps 0.8 lw 2 lc rgb "#AA3377"
    do for [i = 11:15] { unset label i }
    unset arrow 14
    unset arrow 15
}
unset multiplot
