# scattered.gp - random starts, n = 4: where the runs of each method end; linear
# systems of those that converge; and an equilibrium without an inverted triangle
# that is not rest, with the start that led to it.  Of the runs at rest the bars
# have the standard error.
# Reads   data  tables scattered, tangled
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 940,760
set output out
polygons(test, first) = sprintf( \
    "< awk -F'\t' '$0 == \"# tangled\" { on = 1; next } NF == 0 { on = 0 } \
     /^#/ { next } on == 1 { on = 2; print \"x\ty\"; next } \
     on == 2 && (%s) { for (k = 0; k < 4; k++) \
         print $(%d + 2 * (k %% 3)) \"\t\" $(%d + 1 + 2 * (k %% 3)); \
         print \"\" }' '%s'", test, first, first, data)
# bars: three amplitudes with both ends held, then two with the left one only
way(name) = name eq "notes" ? 0 : name eq "search" ? 1 : name eq "demand" ? 2 \
    : name eq "demand+search" ? 3 : 4
place(method, held, a) = way(method) * 6.5 + (held eq "both" ? \
    (a < 0.9 ? 0 : a < 2 ? 1 : 2) : a < 2 ? 3.3 : 4.3)
set style fill solid noborder
set multiplot
set border 3 back ls 9
set lmargin at screen 0.065
set rmargin at screen 0.985
set tmargin at screen 0.90
set bmargin at screen 0.70
set xrange [-1:31.4]
set yrange [0:100]
set ylabel "runs (%)" offset 1
set boxwidth 0.9
unset xtics
set grid y
set key at screen 0.065, screen 0.985 left top horizontal maxrows 1 samplen 1 \
    width 1
all = "rest stable not_spd fails"
count(k) = k == 0 ? 0 : column(word(all, k)) + count(k - 1)
part(k) = 100.0 * count(k) / column("seeds")
unsure = "100.0 * column('rest_error')"
array Color[4] = ["#009E73", "#56B4E9", "#E69F00", "#D55E00"]
array Title[4] = ["back at rest", "in another stable equilibrium", \
    "NOT SPD", "fails"]
plot for [k = 4:1:-1] data index "scattered" using (place(strcol("method"), \
         strcol("held"), column("amplitude"))):(part(k)) \
         with boxes fc rgb Color[k] title Title[k], \
     "" index "scattered" using (place(strcol("method"), strcol("held"), \
         column("amplitude"))):(column("rest") > 0 ? part(1) - @unsure : NaN): \
         (0):(2 * @unsure) with vectors heads size screen 0.003,90 lw 1.2 \
         lc rgb "black" notitle
unset key
set tmargin at screen 0.67
set bmargin at screen 0.545
set logscale y
set yrange [4:800]
set ylabel "systems solved" offset 1
array Way[5] = ["as in the notes", "line search", "on demand", \
    "on demand, line search", "always, line search"]
do for [m = 0:4] {
    set label 10 * m + 1 Way[m + 1] at m * 6.5 + 2.15, screen 0.475 center
    set label 10 * m + 7 "both ends" at m * 6.5 + 1, screen 0.503 center \
        font ",11" textcolor rgb "#555555"
    set label 10 * m + 8 "left end" at m * 6.5 + 3.9, screen 0.503 center \
        font ",11" textcolor rgb "#555555"
    do for [i = 1:5] {
        set label 10 * m + 1 + i word("½ 1 4 1 4", i) at m * 6.5 + \
            (i < 4 ? i - 1 : i - 0.7), screen 0.525 center font ",11"
    }
}
set label 99 "h" at -0.9, screen 0.525 center font ",11"
set label 98 "held:" at -1.1, screen 0.503 right font ",11" textcolor rgb "#555555"
plot data index "scattered" using (column("rest") + column("stable") > 0 ? \
         place(strcol("method"), strcol("held"), column("amplitude")) : NaN): \
         (column("median")):(column("median")):(column("p90")) \
         with yerrorbars lc rgb "#0072B2" lw 2 pt 7 ps 0.6
unset label
unset logscale y
unset ylabel
unset grid
set size ratio -1
set tmargin at screen 0.43
set bmargin at screen 0.01
unset border
unset ytics
set xrange [-3.3:2.6]
set yrange [-2.4:3]
set lmargin at screen 0.03
set rmargin at screen 0.47
set label 1 "a start, 4 h" at graph 0, graph 0.97
plot polygons("$7 > 0", 1) using 1:2 with filledcurves closed \
         fc rgb "#CFE3F0", \
     polygons("$7 <= 0", 1) using 1:2 with filledcurves closed \
         fc rgb "#F2C6A8", \
     polygons("1", 1) using 1:2 with lines lw 1 lc rgb "#0072B2"
set xrange [-1.6:1.05]
set yrange [-1.05:1.1]
set lmargin at screen 0.50
set rmargin at screen 0.97
set label 1 "where it ends" at graph -0.02, graph 0.97
plot polygons("1", 8) using 1:2 with filledcurves closed \
         fc rgb "#C00072B2", \
     polygons("1", 8) using 1:2 with lines lw 1.2 lc rgb "#0072B2"
unset multiplot
