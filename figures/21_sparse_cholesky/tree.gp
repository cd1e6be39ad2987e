# tree.gp - the elimination trees of both orders, drawn on the vertices of the
# body: an edge leads from each vertex to its parent.
# Reads   data  tables rows, dissection (k parent), vertices (i j place)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 580,360
set output out
unset key
unset grid
unset tics
unset border
set size ratio -1
set datafile nocolumnheaders
walk(order, what) = sprintf("< awk -v order=%s -v what=%s -f \
figures/21_sparse_cholesky/tree.awk '%s'", order, what, data)
height(order) = real(system(substr(walk(order, "height"), 3, -1)))
set offsets 0.7, 0.7, 0.7, 0.7
set multiplot layout 1,2 margins 0.02,0.98,0.02,0.85 spacing 0.04,0
do for [k = 1:2] {
    order = word("rows dissection", k)
    set title sprintf(k == 1 ? "row by row: one chain\nof %.0f vertices" : \
                      "by dissection: no chain\nhas more than %.0f", height(order)) \
        offset 0,-0.5 noenhanced
    plot walk(order, "edge") using 1:2:3:4 with vectors nohead ls (k == 1 ? 1 : 3) lw 1.5, \
         "" using 1:2 with points pt 7 ps 0.35 lc rgb "#000000", \
         walk(order, "root") using 1:2 with points pt 7 ps 1.2 lc rgb "#000000"
}
unset multiplot
