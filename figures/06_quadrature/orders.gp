# orders.gp - error of the total load against element length, for a load that
# is smooth, has a kink, jumps.
# Expected slopes: 2, 2, 4; 2, 2, 2; 1, 1, 1.
#
# Reads   data  tables load_smooth, load_kink, load_step (and _orders)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,420
set output out

set logscale xy
set xrange [5.5e-3:0.36]
set format y "10^{%T}"
set format x "%g"
set xtics ("1/128" 1./128, "1/64" 1./64, "1/32" 1./32, "1/16" 1./16, \
           "1/8" 1./8, "1/4" 1./4)
set xtics font ",11"
set xlabel "element length h"
set key above left vertical maxrows 3 reverse Left samplen 1.5 width -2 \
    font ",12"

array Rule[3] = ["midpoint", "trapezoid", "gauss2"]
array Label[3] = ["midpoint", "trapezoid", "Gauss, 2 points"]
# The one number of a column of the table NAME_orders.
order(table, name) = system(sprintf( \
    "awk -F'\t' -v t='# %s_orders' -v c='%s' \
     '$0 == t { on = 1; next } on == 1 { for (i = 1; i <= NF; i++) \
      if ($i == c) k = i; on = 2; next } on == 2 { print $k; exit }' '%s'", \
    table, name, data)) + 0.0
say(text, table, name) = sprintf("%s: order %.2f", text, order(table, name))

set multiplot layout 1,3 margins 0.085,0.985,0.13,0.80 spacing 0.055,0
do for [panel = 1:3] {
    table = word("load_smooth load_kink load_step", panel)
    if (panel == 1) {
        set ylabel "|error| of the total load"
        set yrange [1e-11:1]
    } else {
        unset ylabel
        set format y ""
    }
    set label 1 word("smooth kink jump", panel).( panel == 1 ? " load" : \
        panel == 2 ? ": f = |x - 1/3|" : ": f steps at 1/3") \
        at graph 0.04, graph 0.95 font ",13"
    slope = panel == 3 ? 1 : 2
    top = panel == 3 ? 0.62 : panel == 2 ? 0.6 : 1.6
    set label 2 panel == 3 ? "slope 1" : "slope 2" \
        at 0.02, top * 0.02**slope * (panel == 3 ? 2.2 : 5) font ",12" right
    set label 3 panel == 1 ? "slope 4" : "" at 0.03, 9e-10 font ",12"
    if (panel == 1) {
        plot for [r = 1:3] data index table using "h":(abs(column(Rule[r]))) \
                 with linespoints ls r \
                 title say(Label[r], table, Rule[r]), \
             1.6 * x**2 ls 8 notitle, 0.005 * x**4 ls 8 notitle
    } else {
        plot for [r = 1:3] data index table using "h":(abs(column(Rule[r]))) \
                 with linespoints ls r \
                 title say(Label[r], table, Rule[r]), \
             top * x**slope ls 8 notitle
    }
}
unset multiplot
