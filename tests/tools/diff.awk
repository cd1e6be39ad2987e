# diff.awk - what NN.judge --cells prints (tests/checks/cells.c), for the eye.
#
#     NN.judge --cells MINE REFERENCE | awk -v nn=NN [-v only=TABLE] -f diff.awk
#
# A line for each table, and five cells of each, the worst first; of TABLE all
# cells that differ, in their order.
function is_number(text) {
    return text ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/
}
function pad(text, n) { return sprintf("%-" n "s", text) }
# A difference in units of what the check allows; a word that is another is
# farther off than any number.
function times(off) { return off == "inf" ? 1e300 : off + 0 }
function short(number) { return sprintf(number < 1e5 ? "%.3g" : "%.0e", number) }
function in_words(mine, reference, off, allowed) {
    if (mine == "nan" || mine ~ /inf$/) return "not finite"
    if (!is_number(mine))
        return is_number(reference) ? "a word for a number" : "another word"
    if (!is_number(reference)) return "a number for a word"
    if (off != "inf") return short(off) " times"
    return allowed > 0 ? "over 1e300 times" : "must be equal"
}
# Mine and the reference with as many digits as tell them apart.
function write(c, mine, reference,    digits) {
    for (digits = 6; digits <= 17; digits += digits == 6 ? 4 : 7) {
        a[c] = is_number(mine) ? sprintf("%." digits "g", mine) : mine
        b[c] = is_number(reference) ? sprintf("%." digits "g", reference) : reference
        if (a[c] != b[c]) return
    }
}
function keep(table, row, column, mine, reference, off, said,    c, k) {
    c = ++kept
    cell_table[c] = table; cell_row[c] = row; cell_column[c] = column
    write(c, mine, reference)
    word[c] = said
    size[c] = times(off)
    if (only != "") { list[++listed] = c; return }
    for (k = listed; k >= 1 && size[list[k]] < size[c]; k--) list[k + 1] = list[k]
    list[k + 1] = c
    listed++
    if (++of_table[table] > 5) { # its least goes
        for (k = listed; cell_table[list[k]] != table; k--) ;
        for (; k < listed; k++) list[k] = list[k + 1]
        listed--
        of_table[table]--
    }
}
function print_list(    k, c, w) {
    w["t"] = 5; w["r"] = 3; w["c"] = 6; w["a"] = 4; w["b"] = 9
    for (k = 1; k <= listed; k++) {
        c = list[k]
        if (length(cell_table[c]) > w["t"]) w["t"] = length(cell_table[c])
        if (length(cell_row[c]) > w["r"]) w["r"] = length(cell_row[c])
        if (length(cell_column[c]) > w["c"]) w["c"] = length(cell_column[c])
        if (length(a[c]) > w["a"]) w["a"] = length(a[c])
        if (length(b[c]) > w["b"]) w["b"] = length(b[c])
    }
    for (k = 0; k <= listed; k++) {
        c = list[k]
        print "  " (only != "" ? "" : pad(k ? cell_table[c] : "table", w["t"]) "  ") \
            pad(k ? cell_row[c] : "row", w["r"]) "  " \
            pad(k ? cell_column[c] : "column", w["c"]) "  " \
            pad(k ? a[c] : "mine", w["a"]) "  " \
            pad(k ? b[c] : "reference", w["b"]) "  " \
            (k ? word[c] : "difference / allowed")
    }
}
# Of rows that only one side has: many that follow one another in one line;
# otherwise all for one table, else the first few.
function print_rows(what, n, names,    name, k) {
    if (!n) return
    split(names, name, "\n")
    if (n > 2 && name[n] - name[1] == n - 1) {
        print "  " what ": " name[1] " to " name[n]
        return
    }
    print "  " what ":"
    for (k = 1; k <= n && k in name && (only != "" || k <= 4); k++)
        print "    row " name[k]
    if (k <= n) print "    and " n - k + 1 " more"
}
BEGIN { FS = "\t" }
$1 == "stray" { stray++; next }
$1 == "table" {
    order[++tables] = $2
    rows_mine[$2] = $6; rows_reference[$2] = $7
}
only != "" && $2 != only { next }
$1 == "column" {
    if ($6 == "") no_column[$2] = no_column[$2] " `" $5 "`"
    else if ($7 == "") own_column[$2] = own_column[$2] " `" $5 "`"
    else if ($8 == "-") not_compared[$2] = not_compared[$2] " `" $5 "`"
    has_mine[$2, $5] = $6; has_reference[$2, $5] = $7
}
$1 == "cell" && $6 == "" && has_mine[$2, $5] && !named[$2, $3, "missing"]++ {
    n_missing[$2]++; missing[$2] = missing[$2] $3 " (" $4 ")\n"
}
$1 == "cell" && $7 == "" && has_reference[$2, $5] && !named[$2, $3, "extra"]++ {
    n_extra[$2]++; extra[$2] = extra[$2] $3 " (" $4 ")\n"
}
$1 == "cell" && $8 != "" && $8 != "-" {
    cells[$2]++
    if (times($8) <= 1) next
    differ[$2]++
    said = in_words($6, $7, $8, $9)
    if (times($8) > worst[$2]) { worst[$2] = times($8); say[$2] = said }
    keep($2, $3 " (" $4 ")", $5, $6, $7, $8, said)
}
END {
    for (t = 1; t <= tables; t++) {
        if (length(order[t]) > wide) wide = length(order[t])
        names = names (t > 1 ? ", " : "") order[t]
        if (order[t] == only) there = 1
    }
    if (only != "" && !there) {
        print "There is no table `" only "`; there are: " names
        exit 2
    }
    for (t = 1; t <= tables; t++) {
        k = order[t]
        if (only != "" && k != only) continue
        line = "  " pad(k, wide) "  "
        if (rows_mine[k] == "") line = line "your program prints no such table"
        else if (rows_reference[k] == "") line = line "the reference prints no such table"
        else {
            line = line (differ[k] ? differ[k] : "none") " of " cells[k] + 0 " cells differ"
            if (differ[k]) line = line ", worst: " say[k] (say[k] ~ /times$/ ? " what the check allows" : "")
            if (rows_mine[k] != rows_reference[k])
                line = line "; rows: mine " rows_mine[k] ", reference " rows_reference[k]
        }
        print line
        wrong = differ[k] || n_missing[k] || n_extra[k] || no_column[k] != "" || rows_mine[k] == ""
        if (wrong) bad++
        if (first == "" && differ[k]) first = k
        all += cells[k]
        if (rows_mine[k] == "" || rows_reference[k] == "") continue
        if (no_column[k] != "") print "  missing columns:" no_column[k]
        if (own_column[k] != "") print "  columns that the reference does not have:" own_column[k]
        if (not_compared[k] != "" && only != "") print "  not compared by the check:" not_compared[k]
        print_rows("rows that yours does not have", n_missing[k], missing[k])
        print_rows("rows that the reference does not have", n_extra[k], extra[k])
    }
    if (listed) {
        print (only != "" ? "Cells that differ:" : "The worst of them:")
        print_list()
    }
    if (stray)
        print (stray < 1000 ? stray : "1000 or more") (stray == 1 ? " line" : " lines") \
            " on stdout that belong to no table, which the check refuses: make lesson-" nn " shows them"
    if (!bad) {
        print "No cell differs by more than the check allows."
        print "make check-" nn " tries other options and calls each function, too."
    }
    else if (only == "" && first != "") print "TABLE=" first " shows all of that table."
}
