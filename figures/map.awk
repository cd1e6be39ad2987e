# map.awk - the map of the course, an SVG on stdout.
#
#     awk -f figures/map.awk lessons/[0-9]*.md > figures/map.svg
#
# Minutes and what a lesson rests on are read from the first paragraph of its
# chapter.  An arrow is drawn where no other way leads there.  The place of each
# lesson on the map, its part and its short title stand here.

BEGIN {
    # NN column row part; title; section of the notes
    n = split("\
03 1 1 1;Prescribed values;L2 1.1 (1)|\
04 2 1 1;Two flux ends;L2 1.1 (2)|\
05 3 1 1;Stiffness matrix;L2 1.1 (3)|\
06 4 1 1;Quadrature;L2 1.1 (4)|\
07 5 1 1;Error and order;L2 1.1 (5)|\
08 6 1 1;Element assembly;L2 1.1 (6)|\
01 2 2 2;Deformation;L1 Kinematics|\
02 3 2 2;Energy and stress;L1; L2 2.2, 2.3|\
09 5 2 2;The linear bar;L1 1D Elasticity|\
10 4 2 2;Neo-Hookean bar;L2 2.1 to 2.5; PS|\
11 5 3 2;Newton fails;L2 2.5.5, 2.5.6|\
12 4 3 3;Triangles;L2 3.3.2 to 3.3.4|\
13 4 4 3;Backward Euler;L2 3.3.1, 3.3.5|\
14 3 4 3;Four integrators;L1 Time stepping|\
15 5 4 4;Definiteness;Lecture 3|\
16 6 3 4;Inverted triangles;L3, Figure 5|\
17 3 3 4;Fibres;L1 Anisotropy|\
18 4 5 5;Particles and grid;MPM P2G, G2P|\
19 5 5 5;Particle forces;MPM weak form|\
20 6 5 5;Implicit particles;MPM time step|\
21 3 5 6;Sparse Cholesky;beyond the notes|\
22 3 6 6;Multigrid;beyond the notes|\
23 2 5 6;The least model;the whole course|\
24 2 4 6;In your hands;L1 the loop|\
-- 4 6 0;Where a step fails;after 13|\
-- 5 6 0;Work and precision;after 14|\
-- 6 6 0;Speed;after 14|\
-- 2 6 0;Many machines;after 22", line, "|")
    split("Poisson's equation|Material and bar|The moving square|\
Its limits|Particles (MPM)|Cost and use", part, "|")
    split("#CFE3F0 #FBE3CF #CDEBDD #F2DCEA #FCEFC0 #E4E4E4", fill, " ")
    width = 132; height = 58; left = 8; top = 8; right = 150.8; down = 94
}

FNR == 1 { head = ""; split(FILENAME, path, "/"); nn = substr(path[2], 1, 2) }
FNR == 3 { inside = 1 }
inside { head = head " " $0 }
inside && /\*$/ {
    inside = 0
    if (match(head, /About [0-9]+ minutes/))
        minutes[nn] = substr(head, RSTART + 6, RLENGTH - 14) + 0
    while (match(head, /\]\([0-9][0-9]_/)) {
        rests[nn] = rests[nn] " " substr(head, RSTART + 2, 2)
        head = substr(head, RSTART + RLENGTH)
    }
}

# whether lesson a rests on lesson b, directly or not
function needs(a, b,    k, i, word) {
    k = split(rests[a], word, " ")
    for (i = 1; i <= k; i++)
        if (word[i] == b || needs(word[i], b)) return 1
    return 0
}
function say(x, y, size, anchor, text, more) {
    printf "<text x=\"%g\" y=\"%g\" font-size=\"%d\"%s%s>%s</text>\n", x, y, \
        size, anchor == "" ? "" : " text-anchor=\"" anchor "\"", more, text
}
# from lesson b to lesson a, which rests on it
function arrow(b, a,    x0, y0, x1, y1, way) {
    x0 = X[b]; y0 = Y[b]; x1 = X[a]; y1 = Y[a]
    if (y0 == y1) {                    # beside
        way = sprintf("M%g,%g H%g", x0 + (x1 > x0 ? width : 0), \
            y0 + height / 2, x1 + (x1 > x0 ? -2 : width + 2))
    } else if (y1 < y0 || column[b] == 6) { # sideways, then up or down
        way = y1 < y0 \
            ? sprintf("M%g,%g H%g V%g", x0 + width, y0 + height / 2, \
                x1 + width / 2, y1 + height + 2) \
            : sprintf("M%g,%g V%g H%g", x0 + width / 2, y0 + height, \
                y1 + height / 2, x1 + width + 2)
    } else {                           # down
        way = sprintf("M%g,%g C%g,%g %g,%g %g,%g", x0 + width / 2, y0 + height, \
            x0 + width / 2, y0 + height + 24, x1 + width / 2, y1 - 26, \
            x1 + width / 2, y1 - 2)
    }
    print "<path d=\"" way "\" fill=\"none\" stroke=\"#222\" " \
        "stroke-width=\"1.5\" marker-end=\"url(#tip)\"/>"
}

END {
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" " \
        "height=\"546\" viewBox=\"0 0 900 546\" font-family=\"Helvetica, " \
        "Arial, sans-serif\">"
    print "<title>The map of the course</title>"
    print "<defs><marker id=\"tip\" viewBox=\"0 0 10 8\" refX=\"9\" " \
        "refY=\"4\" markerWidth=\"8\" markerHeight=\"7\" orient=\"auto\" " \
        "markerUnits=\"userSpaceOnUse\">" \
        "<path d=\"M0,0 L10,4 L0,8 z\" fill=\"#222\"/></marker></defs>"
    print "<rect width=\"900\" height=\"546\" fill=\"#ffffff\"/>"
    for (i = 1; i <= n; i++) {
        k = index(line[i], ";")
        split(substr(line[i], 1, k - 1), word, " ")
        rest = substr(line[i], k + 1)
        k = index(rest, ";")
        id[i] = word[1] == "--" ? "--" i : word[1]
        nn = id[i]
        column[nn] = word[2]
        kind[nn] = word[4]
        title[nn] = substr(rest, 1, k - 1)
        where[nn] = substr(rest, k + 1)
        X[nn] = left + right * (word[2] - 1) - (word[2] == 6 ? 2 : 0)
        Y[nn] = top + down * (word[3] - 1)
        sum[kind[nn]] += minutes[nn]
        total += minutes[nn]
        if (kind[nn] && !minutes[nn]) {
            print "map: no minutes for lesson " nn > "/dev/stderr"
            exit 1
        }
    }
    for (i = 1; i <= n; i++) {
        k = split(rests[id[i]], word, " ")
        for (j = 1; j <= k; j++) {
            other = 0
            for (l = 1; l <= k; l++)
                if (l != j && needs(word[l], word[j])) other = 1
            if (!other) arrow(word[j], id[i])
        }
    }
    for (i = 1; i <= n; i++) {
        nn = id[i]
        printf "<rect x=\"%g\" y=\"%g\" width=\"%d\" height=\"%d\" rx=\"5\" " \
            "fill=\"%s\" stroke=\"#222\"%s/>\n", X[nn], Y[nn], width, height, \
            kind[nn] ? fill[kind[nn]] : "#ffffff", \
            kind[nn] ? "" : " stroke-dasharray=\"5 4\""
        if (kind[nn]) {
            say(X[nn] + 8, Y[nn] + 18, 14, "", nn, " font-weight=\"bold\"")
            say(X[nn] + width - 8, Y[nn] + 17, 11, "end", minutes[nn] " min", "")
        } else say(X[nn] + 8, Y[nn] + 17, 11, "", "to read", "")
        say(X[nn] + 8, Y[nn] + 34, 12, "", title[nn], "")
        say(X[nn] + 8, Y[nn] + 50, 11, "", where[nn], " fill=\"#444\"")
    }
    y = top + down + 12
    for (i = 1; i <= 6; i++) {
        printf "<rect x=\"%g\" y=\"%g\" width=\"13\" height=\"13\" rx=\"2\" " \
            "fill=\"%s\" stroke=\"#222\"/>\n", left, y, fill[i]
        say(left + 20, y + 11, 11, "", part[i], "")
        say(left + 20, y + 25, 11, "", sprintf("%d h %02d", sum[i] / 60, \
            sum[i] % 60), " fill=\"#444\"")
        y += 42
    }
    say(left, y + 14, 11, "", sprintf("together %.0f hours", total / 60), "")
    print "<path d=\"M" left "," y + 40 " h34\" stroke=\"#222\" " \
        "stroke-width=\"1.5\" marker-end=\"url(#tip)\"/>"
    say(left + 42, y + 44, 11, "", "is needed for", "")
    say(left, y + 72, 11, "", "L1, L2, L3: lectures", "")
    say(left, y + 88, 11, "", "PS: problem session", "")
    print "</svg>"
}
