# tree.awk - where L has blocks, by walks in the elimination tree: what tree.gp
# draws.
#
#     awk -v order=dissection -v what=entry|fill -f tree.awk DATA
#
# Row k of L has the vertices that are met on the ways from the entries of row k
# of K up the tree to k.  The tree is that of the table `rows` or `dissection`,
# two unknowns per vertex, the places those of the table `vertices`.  Prints
# column, first and last row of the blocks of L that stand below each other and
# are entries of K, or are not.

function meet(a, k, step, v, at) { # the way from the neighbour `at` of a to k
    if (!(at in place)) return
    v = place[at]
    if (v < k) own[k, v] = 1
    for (step = 0; step <= vertices && v < k && v >= 0; step++) {
        L[k, v] = 1
        v = parent[v]
    }
}
BEGIN { FS = "\t" }
/^#/ && NF == 1 { on = substr($0, 3); header = 1; next }
NF < 2 { next }
header { header = 0; next }
on == order && $1 % 2 { parent[int($1 / 2)] = $2 == "-" ? -1 : int($2 / 2) }
on == "vertices" {
    i[vertices + 0] = $1
    j[vertices + 0] = $2
    place[$1, $2] = order == "rows" ? vertices + 0 : int($3)
    vertices++
}
END {
    for (a = 0; a < vertices; a++) {
        k = place[i[a], j[a]]
        if (k < 0 || k >= vertices) continue
        L[k, k] = own[k, k] = 1
        for (s = -1; s <= 1; s += 2) {
            meet(a, k, 0, 0, (i[a] + s) SUBSEP j[a])
            meet(a, k, 0, 0, i[a] SUBSEP (j[a] + s))
            meet(a, k, 0, 0, (i[a] + s) SUBSEP (j[a] + s))
        }
    }
    for (v = 0; v < vertices; v++)
        for (k = v; k <= vertices; k++) {
            here = (k, v) in L && ((k, v) in own) == (what == "entry")
            if (here && !run) first = k
            if (!here && run) print v "\t" first "\t" k - 1
            if (here) blocks++
            run = here
        }
    if (what == "fill") print -9 "\t" blocks + 0 "\t" blocks + 0
}
