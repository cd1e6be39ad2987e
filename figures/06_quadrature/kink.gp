# kink.gp - errors of the solution against element length: a smooth problem, a
# point load inside an element, a jump of beta inside one.
# Expected slopes: 2, 1.5, 1 (with the right mean of beta: 1.5) in L2 and
# 1, 0.5, 0.5 in energy.
#
# Reads   data  tables solution, point_load, jump (and _orders)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,600
set output out

set logscale xy
set xrange [5.5e-3:0.36]
set xtics ("1/128" 1./128, "1/32" 1./32, "1/8" 1./8)
set format y "10^{%T}"
set key above left vertical maxrows 3 reverse Left samplen 1.5 width -2 \
    font ",12"

# The one number of a column of the table NAME_orders.
order(table, name) = system(sprintf( \
    "awk -F'\t' -v t='# %s_orders' -v c='%s' \
     '$0 == t { on = 1; next } on == 1 { for (i = 1; i <= NF; i++) \
      if ($i == c) k = i; on = 2; next } on == 2 { print $k; exit }' '%s'", \
    table, name, data)) + 0.0
# "rule: order in L2, below that in energy", for the upper panels only
say(text, table, suffix) = row == 2 ? "" : sprintf("%s: order %.2f, below %.2f", \
    text, order(table, "L2".suffix), order(table, "energy".suffix))

array Smooth[3] = ["midpoint", "trapezoid", "gauss2"]
array Rule[3] = ["midpoint", "trapezoid", "Gauss"]
array Mean[3] = ["sampled", "exact", "harmonic"]
array Beta[3] = ["β sampled", "mean of β", "On paper 6"]
set multiplot
set tmargin 0
set bmargin 0
do for [row = 1:2] {
    norm = word("L2 energy", row)
    if (row == 2) { unset key }
    set yrange [row == 1 ? 1e-6 : 3e-3 : row == 1 ? 0.2 : 1.5]
    set tmargin at screen (row == 1 ? 0.87 : 0.455)
    set bmargin at screen (row == 1 ? 0.53 : 0.095)
    set xlabel row == 2 ? "element length h" : ""
    do for [col = 1:3] {
        set lmargin at screen 0.085 + 0.308 * (col - 1)
        set rmargin at screen 0.37 + 0.308 * (col - 1)
        set format y col == 1 ? "10^{%T}" : ""
        set ylabel col == 1 ? (row == 1 ? "L^2 norm of the error" : \
            "energy norm of the error") : ""
        set label 1 row == 2 ? "" : col == 1 ? "all data smooth" : \
            col == 2 ? "point load" : "β jumps" at graph 0.04, graph 0.93
        s = row == 1 ? (col == 1 ? 2 : 1.5) : (col == 1 ? 1 : 0.5)
        dashed = (row == 1 ? (col == 1 ? 1.1 : 0.25) : col == 1 ? 2.4 : \
                  col == 2 ? 0.85 : 1.4)
        # above its line, and the second one of the last panel below
        set label 2 sprintf("slope %g", row == 1 && col == 3 ? 1 : s) \
            at 0.012, (row == 1 && col == 3 ? 0.4 * 0.012 : \
                dashed * 0.012**s) * (row == 1 ? 4 : 1.9) center font ",12"
        set label 3 row == 1 && col == 3 ? "slope 1.5" : "" \
            at 0.35, 1.2e-3 right font ",12"
        if (col == 1) {
            plot for [k = 1:3] data index "solution" \
                using "h":(column(norm."_".Smooth[k])) \
                with linespoints ls k \
                title say(Rule[k], "solution", "_".Smooth[k]), \
                dashed * x**s ls 8 notitle
        }
        if (col == 2) {
            plot data index "point_load" using "h":norm \
                with linespoints ls 1 title say("exact load", \
                "point_load", ""), dashed * x**s ls 8 notitle
        }
        if (col == 3) {
            plot for [k = 1:3] data index "jump" \
                using "h":(column(norm."_".Mean[k])) with linespoints ls k + 2 \
                title say(Beta[k], "jump", "_".Mean[k]), \
                dashed * x**s ls 8 notitle, \
                (row == 1 ? 0.4 * x : NaN) ls 8 notitle
        }
    }
}
unset multiplot
