# tree.gp - where L has entries in both orders, by the elimination trees of the
# lesson; orange: fill.
# Reads   data  tables rows, dissection (k parent), vertices (i j place)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 760,400
set output out
unset key
unset grid
unset tics
set border 15 ls 9
set size ratio -1
set datafile nocolumnheaders
set style fill solid noborder
walk(order, what) = sprintf("< awk -v order=%s -v what=%s -f \
figures/21_sparse_cholesky/tree.awk '%s'", order, what, data)
fill(order) = real(system(substr(walk(order, "fill"), 3, -1)." | tail -n 1 | cut -f 2"))
n = real(system("awk '/^# / { on = $2 == \"vertices\" } on && NF > 2 { n++ } \
    END { print n - 1 }' '".data."'"))
set xrange [-2:n + 1]
set yrange [n + 1:-2]
set multiplot layout 1,2 margins 0.01,0.99,0.02,0.92 spacing 0.02,0
do for [order in "rows dissection"] {
    set title sprintf("%s: %.0f blocks fill", order, fill(order)) offset 0,-0.7
    plot for [k = 1:2] walk(order, word("fill entry", k)) \
        using 1:(0.5 * ($2 + $3)):(0.4):(0.5 * ($3 - $2) + 0.4) with boxxy \
        lc rgb word("#D55E00 #0072B2", k)
}
unset multiplot
