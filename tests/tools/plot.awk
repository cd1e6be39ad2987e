# plot.awk - curves of what NN.judge --cells prints (tests/checks/cells.c).
#
#     SPEC='TABLE X Y [logx] [logy] [key=COLUMN]' TABLE= X= Y= KEY= curves=FILE \
#         awk -f tests/tools/plot.awk CELLS
#
# FILE gets a block for each value of the key column: x and y of mine, x and y of
# the reference, |mine - reference|, what the check allows, and y of mine where it
# is marked in the terminal.  stdout gets settings for figures/overlay.gp, and in
# comments what is said to the student; or, with status 2, why there is nothing
# to draw.
function is_number(text) {
    return text ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/
}
function fail(text) { print text; failed = 1; exit 2 }
function quoted(text) { gsub(/'/, "''", text); return "'" text "'" }
# The order of magnitude, some logarithm; not every awk has log().
function magnitude(v,    digits) {
    split(sprintf("%e", v), digits, "e")
    return digits[2] + (digits[1] - 1) / 9
}
# How far v is on an axis from least to most: 0 to n.
function part(v, least, most, log_, n) {
    if (log_) {
        if (v <= 0 || least <= 0) return 0
        v = magnitude(v); least = magnitude(least); most = magnitude(most)
    }
    return most > least ? int(n * (v - least) / (most - least) + 0.5) : 0
}
# In the terminal one point of a curve is a mark for all near it.
function marked(k, r) {
    if (!is_number(mine[r, x]) || !is_number(mine[r, y])) return 0
    return !near[k, part(mine[r, x], least_x, most_x, "logx" in word, 20), \
                 part(mine[r, y], least_y, most_y, "logy" in word, 16)]++
}
# Whether a column is positive and has numbers that differ by a factor of 1000.
function wide(column,    r, v, least, most) {
    for (r = 1; r <= rows; r++) {
        v = (r, column) in reference ? reference[r, column] : mine[r, column]
        if (!is_number(v)) continue
        if (v <= 0) return 0
        if (least == "" || v + 0 < least) least = v + 0
        if (v + 0 > most) most = v + 0
    }
    return most > 1000 * least
}
function number(text) { return is_number(text) ? text : "NaN" }
function has(column) { return index("\n" columns, "\n" column "\n") > 0 }
function listed(names) { gsub(/\n/, ", ", names); sub(/, $/, "", names); return names }
BEGIN {
    FS = "\t"
    n = split(ENVIRON["SPEC"], spec, " ")
    table = ENVIRON["TABLE"] != "" ? ENVIRON["TABLE"] : spec[1]
    if (table == spec[1]) {
        x = spec[2]; y = spec[3]
        for (k = 4; k <= n; k++) {
            if (spec[k] ~ /^key=/) key = substr(spec[k], 5)
            else word[spec[k]] = 1
        }
    }
    told_x = x; told_y = y
    if (ENVIRON["X"] != "") x = ENVIRON["X"]
    if (ENVIRON["Y"] != "") y = ENVIRON["Y"]
    if (ENVIRON["KEY"] != "") key = ENVIRON["KEY"]
}
$1 == "table" { tables = tables $2 "\n"; if ($2 == table) { there = 1; of_mine = $6 != "" } }
$1 == "cell" && ($8 == "inf" || $8 + 0 > 1) {
    if (!off_in[$2, $5]++ && ++wrong <= 8) {
        if (wrong > 1) where = where ($2 == last ? ", " : " of `" last "`; ")
        where = where "`" $5 "`"
        last = $2
    }
    # of what can be drawn the worst; a count that must be equal is the least
    size = $8 != "inf" ? $8 + 0 : $9 > 0 ? 1e300 : 1
    if (is_number($6) && is_number($7) && size > worst) {
        worst = size; worst_table = $2; worst_column = $5
    }
}
$2 != table { next }
$1 == "column" { columns = columns $5 "\n"; compared[$5] = $8 != "-" && $7 != "" }
$1 == "cell" {
    if ($3 SUBSEP ($7 == "") != before) rows++ # those of mine alone count anew
    before = $3 SUBSEP ($7 == "")
    if ($6 != "") mine[rows, $5] = $6
    if ($7 != "") reference[rows, $5] = $7
    if ($9 != "") allowed[rows, $5] = $9
    if (is_number($6) || is_number($7)) numbers[$5]++
}
END {
    if (failed) exit 2
    if (!there) fail("There is no table `" table "`; there are: " listed(tables))
    n = split(columns, name, "\n") - 1
    for (k = 1; k <= n; k++) { # without a word: the first two with numbers
        if (x == "" && numbers[name[k]]) x = name[k]
        else if (y == "" && numbers[name[k]] && name[k] != x) y = name[k]
    }
    for (k = 1; k <= 3; k++) {
        column = k == 1 ? x : k == 2 ? y : key
        if (column != "" && !has(column))
            fail("Table `" table "` has no column `" column "`; it has: " listed(columns))
        if (k < 3 && (column == "" || !numbers[column]))
            fail("Table `" table "`: no numbers to draw in column `" column "`")
    }
    # where nothing is said of it, an axis of orders of magnitude has a log scale
    if (x != told_x && wide(x)) word["logx"]; else if (x != told_x) delete word["logx"]
    if (y != told_y && wide(y)) word["logy"]; else if (y != told_y) delete word["logy"]
    for (r = 1; r <= rows; r++) {
        curve = key == "" ? "" : (r, key) in reference ? reference[r, key] : mine[r, key]
        if (!(curve in place)) { place[curve] = ++curves; title[curves] = curve }
        row[place[curve], ++length_of[place[curve]]] = r
    }
    for (r = 1; r <= rows; r++) {
        if (!is_number(mine[r, x]) || !is_number(mine[r, y])) continue
        v = mine[r, x] + 0
        if (!points || v < least_x && !("logx" in word && v <= 0)) least_x = v
        if (!points || v > most_x) most_x = v
        v = mine[r, y] + 0
        if (!points || v < least_y && !("logy" in word && v <= 0)) least_y = v
        if (!points || v > most_y) most_y = v
        points++
    }
    # mine may leave the picture, where the reference would be a line in it
    for (r = 1; r <= rows; r++) {
        if (!is_number(reference[r, y])) continue
        v = reference[r, y] + 0
        if (!(references++) || v < bottom) bottom = v
        if (references == 1 || v > top) top = v
    }
    span = top > bottom ? top - bottom : top < 0 ? -top : top
    if (!("logy" in word) && points && span > 0 && \
        (most_y > top + 30 * span || least_y < bottom - 30 * span)) {
        extremes = sprintf("from %.3g to %.3g", least_y, most_y)
        if (least_y < bottom) bottom = least_y > bottom - span ? least_y : bottom - span
        if (most_y > top) top = most_y < top + span ? most_y : top + span
        least_y = bottom; most_y = top
    }
    # what is 0 is drawn at the lower edge of the differences
    for (r = 1; r <= rows; r++) {
        if (!((r, y) in mine) || !((r, y) in reference)) continue
        if (!is_number(mine[r, y]) || !is_number(reference[r, y])) continue
        off[r] = mine[r, y] - reference[r, y]
        if (off[r] < 0) off[r] = -off[r]
        pairs++
        if (off[r] > high) high = off[r]
        a = (r, y) in allowed ? allowed[r, y] + 0 : 0
        if (a > high) high = a
        if (a > 0) allows = 1
        if (a > 0 && (low == "" || a < low)) low = a
    }
    low = low > 0 ? low * 1e-3 : high > 0 ? high * 1e-6 : 1e-18
    file = ENVIRON["curves"]
    printf "" >file
    for (k = 1; k <= curves; k++) {
        if (k > 1) print "\n" >file
        drawn = title[k]
        if (is_number(drawn)) drawn = key " = " sprintf("%.6g", drawn)
        print "x\tmine" (drawn == "" ? "" : ": " drawn) "\tx\treference\tdifference\tallowed\tmarked" >file
        for (i = 1; i <= length_of[k]; i++) {
            r = row[k, i]
            print number(mine[r, x]) "\t" number(mine[r, y]) "\t" \
                number(reference[r, x]) "\t" number(reference[r, y]) "\t" \
                (r in off ? (off[r] > low ? off[r] : low) : "NaN") "\t" \
                ((r, y) in allowed && allowed[r, y] > 0 ? allowed[r, y] : "NaN") \
                "\t" (marked(k, r) ? mine[r, y] : "NaN") >file
        }
        if (length_of[k] > longest) longest = length_of[k]
    }
    close(file)
    print "# Table `" table "`, `" y "` over `" x "`" \
        (key == "" ? "" : ", a curve for each `" key "`")
    if (ENVIRON["TABLE"] ENVIRON["X"] ENVIRON["Y"] == "")
        print "# TABLE= X= Y= KEY= draw others: tables " listed(tables)
    else print "# It has the columns " listed(columns)
    if (!points) print "# Nothing of yours is there to draw: this is the reference alone."
    if (extremes != "") print "# Yours leaves the picture: it goes " extremes "."
    if (wrong)
        print "# Off by more than the check allows: " where " of `" last "`" (wrong > 8 ? " ..." : "")
    if (worst && !((table, y) in off_in)) {
        print "# make plot-" ENVIRON["nn"] \
            (worst_table == spec[1] ? "" : " TABLE=" worst_table) \
            " Y=" worst_column (ENVIRON["ARGS"] == "" ? "" : \
            " ARGS='" ENVIRON["ARGS"] "'") " draws the worst of them."
        print "instead = " quoted(worst_table " " worst_column)
    }
    print "name = " quoted(table)
    print "x_name = " quoted(x)
    print "y_name = " quoted(y)
    print "curves = " curves + 0
    print "longest = " longest + 0
    print "keyed = " (key != "")
    print "points = " points + 0
    if (!compared[y]) print "# The check does not compare `" y "`."
    else if (pairs && !allows) print "# The check allows no difference."
    print "pairs = " (high > 0 ? pairs + 0 : 0)
    print "compared = " allows + 0
    print "low = " low
    print "high = " (high > low ? high : low)
    print "leaves = " (extremes != "")
    print "bottom = " bottom + 0
    print "top = " top + 0
    print "log_x = " ("logx" in word)
    print "log_y = " ("logy" in word)
}
