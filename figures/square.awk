# square.awk - a deformed mesh and its J, for square.gp.
#
#     awk -v table=nodes [-v k=12] -v what=WHAT -f figures/square.awk DATA
#
# The table has X, Y, u_x, u_y of the vertices, row by row of the mesh (mesh.h),
# and with k only the rows with this k in column k count; or it has F11, F21 and
# J of all triangles of a square whose left side stays, which gives the places.
# WHAT is a class of J: 0 for J <= 0, c for what is nearest to c / 10, 1 to 20:
# prints its triangles; `classes`: those that there are, 0 last; `mesh`: all lines;
# `middle`: number and middle of every triangle; `edge`: the outline; `reach`: the largest coordinate; `said`: what is odd.
# A vertex whose coordinates are no numbers, or over 30 m, is left out.

function good(v) { return v ~ /^[-+]?[.0-9]/ && v > -30 && v < 30 }
function put(a, to_x, to_y) {
    if (!good(to_x) || !good(to_y)) { odd++; return }
    x[a] = to_x
    y[a] = to_y
    if (to_x > reach) reach = to_x
    if (-to_x > reach) reach = -to_x
    if (to_y > reach) reach = to_y
    if (-to_y > reach) reach = -to_y
}
function turn(p, q, r, x, y) {
    return (x[q] - x[p]) * (y[r] - y[p]) - (x[r] - x[p]) * (y[q] - y[p])
}
function point(a) { print (a in x) ? x[a] "\t" y[a] : "" }
function line(a, step, count, i) { # a blank line ends it, and stands for a gap
    for (i = 0; i <= count; i++) point(a + i * step)
    print ""
}
# the places, from F of the triangles on both sides of the cuts
function places(i, j, a, e, h) {
    while (2 * n * n < triangles) n++
    rows = n
    h = 2 / n
    for (j = 0; j <= n; j++)
        for (i = 0; i <= n; i++) {
            a = j * (n + 1) + i
            X[a] = -1 + i * h
            Y[a] = -1 + j * h
            e = 2 * ((j < n ? j : n - 1) * n + i - 1) + (j == n)
            if (i == 0) put(a, X[a], Y[a])
            else if (!(a - 1 in x) || !good(F11[e]) || !good(F21[e])) odd++
            else put(a, x[a - 1] + h * F11[e], y[a - 1] + h * F21[e])
        }
}
function triangle(e, p, q, r, now, c) {
    if (!(p in x) || !(q in x) || !(r in x)) return
    now = e in J ? J[e] : turn(p, q, r, x, y) / turn(p, q, r, X, Y)
    c = now > 0 ? int(10 * now + 0.5) : 0
    if (now > 0 && c < 1) c = 1
    if (c > 20) c = 20
    count[c]++
    if (what == "middle")
        print e "\t" (x[p] + x[q] + x[r]) / 3 "\t" (y[p] + y[q] + y[r]) / 3
    if (what != c "") return
    point(p)
    point(q)
    point(r)
    print ""
}

BEGIN { FS = "\t"; n = rows = 0 }
/^#/ && NF == 1 { on = $0 == "# " table; header = 0; next }
!on || NF < 2 { next }
!header {
    header = 1
    for (f = 1; f <= NF; f++) at[$f] = f
    next
}
k != "" && $at["k"] != k { next }
"J" in at {
    F11[triangles + 0] = $at["F11"]
    F21[triangles + 0] = $at["F21"]
    J[triangles++ + 0] = $at["J"]
    next
}
{
    a = vertices++ + 0
    X[a] = $at["X"]
    Y[a] = $at["Y"]
    if (a > 0 && !n && Y[a] != Y[a - 1]) n = a - 1
    if (!good($at["u_x"]) || !good($at["u_y"])) odd++
    else put(a, X[a] + $at["u_x"], Y[a] + $at["u_y"])
}
END {
    if (triangles) places()
    else if (n) rows = int(vertices / (n + 1)) - 1
    top = rows * (n + 1)
    if (what == "reach") print reach + 0
    if (what == "mesh" || what == "edge") {
        for (j = 0; j <= rows; j += what == "edge" ? rows : 1)
            line(j * (n + 1), 1, n)
        for (i = 0; i <= n; i += what == "edge" ? n : 1) line(i, n + 1, rows)
    }
    if (what == "mesh") {
        for (j = rows - 1; j >= 0; j--)
            line(j * (n + 1), n + 2, n < rows - j ? n : rows - j)
        for (i = 1; i < n; i++) line(i, n + 2, rows < n - i ? rows : n - i)
    }
    for (e = 0; e < 2 * n * rows; e++) {
        p = int(e / 2 / n) * (n + 1) + int(e / 2) % n
        if (e % 2) triangle(e, p, p + n + 2, p + n + 1)
        else triangle(e, p, p + 1, p + n + 2)
    }
    if (what == "classes") for (c = 20; c >= 0; c--) if (count[c]) printf "%d ", c
    if (what == "said" && count[0]) printf "J ≤ 0: %d triangles   ", count[0]
    if (what == "said" && odd) printf "no place for %d vertices", odd
}
