# tree.awk - the elimination tree, drawn on the body: what tree.gp draws.
#
#     awk -v order=dissection -v what=edge|root|height -f tree.awk DATA
#
# The tree is that of the table `rows` or `dissection`, two unknowns per vertex;
# the places are those of the table `vertices`.  Prints i and j of a vertex and
# the way to its parent, or i and j of what has no parent, or how many vertices
# the longest way up to there has.

BEGIN { FS = "\t" }
/^#/ && NF == 1 { on = substr($0, 3); header = 1; next }
NF < 2 { next }
header { header = 0; next }
on == order && $1 % 2 { parent[int($1 / 2)] = $2 == "-" ? -1 : int($2 / 2) }
on == "vertices" {
    k = order == "rows" ? vertices + 0 : int($3)
    i[k] = $1
    j[k] = $2
    vertices++
}
END {
    for (k = 0; k < vertices; k++) { # a parent has a larger number
        p = parent[k]
        if (p >= 0 && p < vertices && below[k] + 1 > below[p]) below[p] = below[k] + 1
        if (below[k] + 1 > height) height = below[k] + 1
        if (what == "edge" && p >= 0)
            print i[k] "\t" j[k] "\t" i[p] - i[k] "\t" j[p] - j[k]
        if (what == "root" && p < 0) print i[k] "\t" j[k]
    }
    if (what == "height") print height
}
