# map.awk - the map of the course, an SVG on stdout.
#
#     awk -f figures/map.awk lessons/[0-9]*.md figures/*/README.md
#     awk -v free=1 -f ...      "column row" of a place for one more
#
# All is read from the head of each chapter, before its first section: minutes,
# and what it rests on, from the paragraph there, and from the comment behind it
#
#     <!-- map 4 2 2; Neo-Hookean bar; L2 2.1 to 2.5; PS -->
#
# the place (column 1 to 6, row from 1), the part of the course (`-` for what is
# only read), a short title, and the section of the notes, which is not drawn,
# or after which lesson it may be read.  There are as many rows as the chapters
# ask for.  An arrow is drawn where no other way leads there, round about where
# boxes are in its way.  A chapter without a place and two in one are errors.

BEGIN {
    split("Poisson|Material, bar|Moving square|Its limits|" \
        "Particles|Cost and use", part, "|")
    split("#CFE3F0 #FBE3CF #CDEBDD #F2DCEA #FCEFC0 #E4E4E4", fill, " ")
    width = 134; height = 76; left = 8; top = 8; right = 150.8; down = 114
}

function bad(text) {
    print "map: " text > "/dev/stderr"
    failed = 1
    exit 1
}
function placed(    word, k, text) {
    text = $0
    sub(/^<!-- map */, "", text)
    sub(/ *-->$/, "", text)
    k = index(text, ";")
    split(substr(text, 1, k - 1), word, " ")
    text = substr(text, k + 2)
    k = index(text, ";")
    if (!k || word[1] !~ /^[1-6]$/ || word[2] !~ /^[1-9][0-9]*$/ || \
        word[3] !~ /^([1-6]|-)$/)
        bad(FILENAME ": column row part; title; section")
    column[nn] = word[1]; row[nn] = word[2]; kind[nn] = word[3] + 0
    if (at[word[1], word[2]] != "")
        bad(FILENAME ": the place of " at[word[1], word[2]])
    at[word[1], word[2]] = nn
    if (row[nn] > rows) rows = row[nn]
    title[nn] = substr(text, 1, k - 1)
    where[nn] = substr(text, k + 2)
}

FNR == 1 {
    head = ""
    split(FILENAME, path, "/")
    nn = path[1] == "lessons" ? substr(path[2], 1, 2) : path[2]
    id[++n] = nn
    file[n] = FILENAME
    heading = 1
}
/^## / { heading = inside = 0 }
heading && FNR == 3 { inside = 1 }
inside { head = head " " $0 }
inside && /\*$/ {
    inside = 0
    if (match(head, /About [0-9]+ minutes/))
        minutes[nn] = substr(head, RSTART + 6, RLENGTH - 14) + 0
    while (nn ~ /^[0-9]/ && match(head, /\]\([0-9][0-9]_/)) {
        rests[nn] = rests[nn] " " substr(head, RSTART + 2, 2)
        head = substr(head, RSTART + RLENGTH)
    }
}
heading && /^<!-- map / { placed() }

# whether a box stands in these columns and rows, but for those of a and b
function occupied(c0, c1, r0, r1, a, b,    c, r) {
    for (c = c0 < c1 ? c0 : c1; c <= c0 || c <= c1; c++)
        for (r = r0 < r1 ? r0 : r1; r <= r0 || r <= r1; r++)
            if (at[c, r] != "" && at[c, r] != a && at[c, r] != b) return 1
    return 0
}
# whether lesson a rests on lesson b, directly or not
function needs(a, b,    k, i, word) {
    k = split(rests[a], word, " ")
    for (i = 1; i <= k; i++)
        if (word[i] == b || needs(word[i], b)) return 1
    return 0
}
# whether the arrow from b to a runs over a box, in the first ways of arrow()
function over(b, a) {
    if (row[a] == row[b])
        return occupied(column[b], column[a], row[a], row[a], a, b)
    if (row[a] < row[b])
        return occupied(column[b], column[a], row[b], row[b], a, b) || \
               occupied(column[a], column[a], row[a], row[b], a, b)
    if (column[b] == 6)
        return occupied(6, 6, row[b], row[a], a, b) || \
               occupied(6, column[a], row[a], row[a], a, b)
    return row[a] > row[b] + 1 && \
           occupied(column[b], column[a], row[b] + 1, row[a] - 1, a, b)
}
function crossings(    i, sum) {
    for (i = 1; i <= arrows; i++) sum += over(tail[i], tip[i])
    return sum + 0
}
# after how many letters of a title its first line ends
function two_lines(text,    k, best) {
    if (length(text) <= 12) return length(text)
    for (k = 1; k <= 12; k++)
        if (substr(text, k + 1, 1) == " ") best = k
    return best ? best : length(text)
}
function say(x, y, size, anchor, text, more) {
    if (anchor != "") more = " text-anchor=\"" anchor "\"" more
    printf "<text x=\"%g\" y=\"%g\" font-size=\"%d\"%s>%s</text>\n", x, y, \
        size, more, text
}
# from lesson b to lesson a, which rests on it
function arrow(b, a,    x0, y0, x1, y1, way) {
    x0 = X[b]; y0 = Y[b]; x1 = X[a]; y1 = Y[a]
    if (over(b, a) && row[a] == row[b] - 1) { # between the two rows
        way = sprintf("M%g,%g V%g H%g V%g", x0 + width / 2 - 16, y0, y0 - 12, \
            x1 + width / 2, y1 + height + 2)
    } else if (over(b, a) && row[a] == row[b]) { # below what lies between
        way = sprintf("M%g,%g V%g H%g V%g", x0 + width / 2 - 8, y0 + height, \
            y0 + height + 12, x1 + width / 2, y1 + height + 2)
    } else if (over(b, a)) { # round about: below b, left of the column of a
        way = sprintf("M%g,%g V%g H%g V%g H%g V%g", x0 + width / 2 - 8, \
            y0 + height, y0 + height + 12, x1 - 9, \
            y1 > y0 ? y1 - 12 : y1 + height + 12, x1 + width / 2, \
            y1 > y0 ? y1 - 2 : y1 + height + 2)
    } else if (y0 == y1) {             # beside
        way = sprintf("M%g,%g H%g", x0 + (x1 > x0 ? width : 0), \
            y0 + height / 2, x1 + (x1 > x0 ? -2 : width + 2))
    } else if (y1 < y0 || column[b] == 6) { # sideways, then up or down
        way = y1 < y0 \
            ? sprintf("M%g,%g H%g V%g", x0 + width, y0 + height / 2, \
                x1 + width / 2, y1 + height + 2) \
            : sprintf("M%g,%g V%g H%g", x0 + width / 2, y0 + height, \
                y1 + height / 2, x1 + width + 2)
    } else if (column[a] < column[b] - 1) { # level, below other arrows
        way = sprintf("M%g,%g V%g H%g V%g", x0 + width / 2 - 24, y0 + height, \
            y0 + height + 22, x1 + width / 2 + 28, y1 - 2)
    } else {                           # down
        way = sprintf("M%g,%g C%g,%g %g,%g %g,%g", x0 + width / 2, y0 + height, \
            x0 + width / 2, y0 + height + 24, x1 + width / 2, y1 - 26, \
            x1 + width / 2, y1 - 2)
    }
    print "<path d=\"" way "\" fill=\"none\" stroke=\"#222\" " \
        "stroke-width=\"1.5\" marker-end=\"url(#tip)\"/>"
}

END {
    if (failed) exit 1
    for (i = 1; i <= n; i++) {
        nn = id[i]
        if (!(nn in row)) bad(file[i] ": no place on the map")
        if (kind[nn] && !minutes[nn]) bad(file[i] ": no minutes")
        X[nn] = left + right * (column[nn] - 1) - (column[nn] == 6 ? 2 : 0)
        Y[nn] = top + down * (row[nn] - 1)
        sum[kind[nn]] += minutes[nn]
        if (kind[nn]) total += minutes[nn]
    }
    for (i = 1; i <= n; i++) {
        k = split(rests[id[i]], word, " ")
        for (j = 1; j <= k; j++) {
            other = 0
            for (l = 1; l <= k; l++)
                if (l != j && needs(word[l], word[j])) other = 1
            if (!other) { tail[++arrows] = word[j]; tip[arrows] = id[i] }
        }
    }
    for (r = 2; free && r <= rows + 1; r++)
        for (c = 2; c <= 6; c++) {
            if (at[c, r] != "") continue
            before = crossings()
            at[c, r] = "a new one"
            if (crossings() == before) { print c, r; exit }
            at[c, r] = ""
        }
    bottom = 2 * top + down * (rows - 1) + height + 2
    if (bottom < 515) bottom = 515 # what stands on the left
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" " \
        "height=\"" bottom "\" viewBox=\"0 0 900 " bottom "\" " \
        "font-family=\"Helvetica, Arial, sans-serif\">"
    print "<title>The map of the course</title>"
    print "<defs><marker id=\"tip\" viewBox=\"0 0 10 8\" refX=\"9\" " \
        "refY=\"4\" markerWidth=\"8\" markerHeight=\"7\" orient=\"auto\" " \
        "markerUnits=\"userSpaceOnUse\">" \
        "<path d=\"M0,0 L10,4 L0,8 z\" fill=\"#222\"/></marker></defs>"
    print "<rect width=\"900\" height=\"" bottom "\" fill=\"#ffffff\"/>"
    for (i = 1; i <= arrows; i++) arrow(tail[i], tip[i])
    for (i = 1; i <= n; i++) {
        nn = id[i]
        printf "<rect x=\"%g\" y=\"%g\" width=\"%d\" height=\"%d\" rx=\"5\" " \
            "fill=\"%s\" stroke=\"#222\"%s/>\n", X[nn], Y[nn], width, height, \
            kind[nn] ? fill[kind[nn]] : "#ffffff", \
            kind[nn] ? "" : " stroke-dasharray=\"5 4\""
        if (kind[nn]) {
            say(X[nn] + 7, Y[nn] + 22, 18, "", nn, " font-weight=\"bold\"")
            say(X[nn] + width - 7, Y[nn] + 22, 18, "end", minutes[nn] " min", \
                "")
        } else say(X[nn] + 7, Y[nn] + 22, 18, "", "read " where[nn], "")
        k = two_lines(title[nn])
        say(X[nn] + 7, Y[nn] + 44, 18, "", substr(title[nn], 1, k), "")
        say(X[nn] + 7, Y[nn] + 65, 18, "", substr(title[nn], k + 2), "")
    }
    y = top + down + 12
    for (i = 1; i <= 6; i++) {
        printf "<rect x=\"%g\" y=\"%g\" width=\"13\" height=\"13\" rx=\"2\" " \
            "fill=\"%s\" stroke=\"#222\"/>\n", left, y, fill[i]
        say(left + 19, y + 13, 18, "", part[i], "")
        say(left + 19, y + 33, 18, "", sprintf("%d h %02d", sum[i] / 60, \
            sum[i] % 60), " fill=\"#444\"")
        y += 52
    }
    say(left, y + 17, 18, "", sprintf("in all %.0f h", total / 60), "")
    print "<path d=\"M" left "," y + 46 " h22\" stroke=\"#222\" " \
        "stroke-width=\"1.5\" marker-end=\"url(#tip)\"/>"
    say(left + 28, y + 51, 18, "", "needed for", "")
    print "</svg>"
}
