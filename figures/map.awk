# map.awk - the map of the course, an SVG on stdout.
#
#     awk -f figures/map.awk lessons/[0-9]*.md figures/*/README.md
#     awk -v free=1 -f ...      "column row" of a place for one more room
#
# All is read from the head of each chapter, before its first section: minutes,
# and what it rests on, from the paragraph there, and from the comment behind it
#
#     <!-- map 1 5 2; Neo-Hookean bar; L2 2.1 to 2.5; PS -->
#
# the place (column 1 to 5, row from 1), the part of the course (`-` for what is
# only read), a short title, and the section of the notes, which is not drawn,
# or after which lesson it may be read.  Column 1 is the course, from above; a
# room stands in the row of the lesson of the course that it is entered from.
# An arrow leads to a room from the room before it in its row if it rests on
# that, otherwise from the course; what else it rests on is named in its box.

BEGIN {
    split("Poisson|Material, bar|Moving square|Its limits|" \
        "Particles|Cost and use", part, "|")
    split("#CFE3F0 #FBE3CF #CDEBDD #F2DCEA #FCEFC0 #E4E4E4", fill, " ")
    width = 160; height = 72; left = 8; top = 8; right = 181; down = 96
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
    if (!k || word[1] !~ /^[1-5]$/ || word[2] !~ /^[1-9][0-9]*$/ || \
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

# whether lesson a rests on lesson b, directly or not
function needs(a, b,    k, i, word) {
    k = split(rests[a], word, " ")
    for (i = 1; i <= k; i++)
        if (word[i] == b || needs(word[i], b)) return 1
    return 0
}
# the room of its own row, before it, on which a room rests; or the course
function entry(a,    c) {
    for (c = column[a] - 1; c > 1; c--)
        if (needs(a, at[c, row[a]])) return at[c, row[a]]
    return at[1, row[a]]
}
# rooms of other rows that a room rests on, and none that these rest on
function besides(a,    k, i, j, word, text, other) {
    k = split(rests[a], word, " ")
    for (i = 1; i <= k; i++) {
        if (column[word[i]] == 1 || row[word[i]] == row[a]) continue
        other = 0
        for (j = 1; j <= k; j++) if (needs(word[j], word[i])) other = 1
        if (!other) text = text (text == "" ? "after " : ", ") word[i]
    }
    return text
}
# after how many letters of a title its first line ends
function two_lines(text,    k, best) {
    if (length(text) <= 18) return length(text)
    for (k = 1; k <= 18; k++)
        if (substr(text, k + 1, 1) == " ") best = k
    return best ? best : length(text)
}
function say(x, y, size, anchor, text, more) {
    if (anchor != "") more = " text-anchor=\"" anchor "\"" more
    printf "<text x=\"%g\" y=\"%g\" font-size=\"%d\"%s>%s</text>\n", x, y, \
        size, more, text
}
function line(way, thick) {
    print "<path d=\"" way "\" fill=\"none\" stroke=\"#222\" " \
        "stroke-width=\"" thick "\" marker-end=\"url(#tip)\"/>"
}
# from b to a: down the course, beside it, or below what lies between
function arrow(b, a) {
    if (column[a] == 1)
        line(sprintf("M%g,%g V%g", X[b] + width / 2, Y[b] + height, \
            Y[a] - 3), 4)
    else if (column[a] == column[b] + 1)
        line(sprintf("M%g,%g H%g", X[b] + width, Y[b] + height / 2, \
            X[a] - 2), 1.5)
    else
        line(sprintf("M%g,%g V%g H%g V%g", X[b] + width - 20, \
            Y[b] + height, Y[b] + height + 12, X[a] + width / 2, \
            Y[a] + height + 2), 1.5)
}

END {
    if (failed) exit 1
    for (i = 1; i <= n; i++) {
        nn = id[i]
        if (!(nn in row)) bad(file[i] ": no place on the map")
        if (at[1, row[nn]] == "") bad(file[i] ": a row without a lesson")
        if (kind[nn] && !minutes[nn]) bad(file[i] ": no minutes")
        X[nn] = left + right * (column[nn] - 1)
        Y[nn] = top + down * (row[nn] - 1)
        sum[column[nn] == 1] += kind[nn] ? minutes[nn] : 0
    }
    for (r = rows; free && r; r--)
        for (c = 2; c <= 5; c++)
            if (at[c, r] == "") { print c, r; exit }
    bottom = 2 * top + down * (rows - 1) + height + 14
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" " \
        "height=\"" bottom "\" viewBox=\"0 0 900 " bottom "\" " \
        "font-family=\"Helvetica, Arial, sans-serif\">"
    print "<title>The map of the course</title>"
    print "<defs><marker id=\"tip\" viewBox=\"0 0 10 8\" refX=\"9\" " \
        "refY=\"4\" markerWidth=\"10\" markerHeight=\"9\" orient=\"auto\" " \
        "markerUnits=\"userSpaceOnUse\">" \
        "<path d=\"M0,0 L10,4 L0,8 z\" fill=\"#222\"/></marker></defs>"
    print "<rect width=\"900\" height=\"" bottom "\" fill=\"#ffffff\"/>"
    for (i = 1; i <= n; i++) {
        nn = id[i]
        if (column[nn] > 1 && kind[nn]) arrow(entry(nn), nn)
        else if (column[nn] == 1 && row[nn] > 1) arrow(at[1, row[nn] - 1], nn)
    }
    for (i = 1; i <= n; i++) {
        nn = id[i]
        printf "<rect x=\"%g\" y=\"%g\" width=\"%d\" height=\"%d\" rx=\"5\" " \
            "fill=\"%s\" stroke=\"#222\"%s/>\n", X[nn], Y[nn], width, height, \
            kind[nn] ? fill[kind[nn]] : "#ffffff", !kind[nn] ? \
            " stroke-dasharray=\"5 4\"" : column[nn] == 1 ? \
            " stroke-width=\"3\"" : ""
        if (kind[nn]) {
            say(X[nn] + 7, Y[nn] + 22, 18, "", nn, " font-weight=\"bold\"")
            say(X[nn] + width - 7, Y[nn] + 22, 18, "end", minutes[nn] " min", \
                "")
        } else say(X[nn] + 7, Y[nn] + 22, 18, "", "read " where[nn], "")
        k = two_lines(title[nn])
        say(X[nn] + 7, Y[nn] + 43, 18, "", substr(title[nn], 1, k), "")
        more = substr(title[nn], k + 2)
        if (more == "" && column[nn] > 1) more = besides(nn)
        if (more != "") say(X[nn] + 7, Y[nn] + 64, 18, "", more, "")
    }
    # beside the first lessons, which have no rooms
    x = left + right + 40; y = top + 22
    say(x, y, 20, "", sprintf("The course: %.0f hours, estimated", sum[1] / 60), \
        " font-weight=\"bold\"")
    say(x, y + 27, 20, "", sprintf("Rooms beside it: %.0f hours, " \
        "estimated", sum[0] / 60), "")
    for (i = 1; i <= 6; i++) {
        c = x + 220 * ((i - 1) % 3); r = y + 50 + 30 * int((i - 1) / 3)
        printf "<rect x=\"%g\" y=\"%g\" width=\"15\" height=\"15\" rx=\"2\" " \
            "fill=\"%s\" stroke=\"#222\"/>\n", c, r, fill[i]
        say(c + 22, r + 14, 18, "", part[i], "")
    }
    print "</svg>"
}
