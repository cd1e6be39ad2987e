# show.awk - named tables for the eye.
#
#     awk -f tests/tools/show.awk -v show=NAME FILE
#
# The table NAME is printed, aligned on the right, numbers to six digits, at most
# 20 rows of it; of the others the name and the number of rows; and the lines
# that belong to no table.
function is_number(text) {
    return text ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/
}
function print_rows(    r, i, line) { # as many columns as fit into 100 places
    shown = total = 0
    while (shown < n_column && total + width[shown + 1] <= 100)
        total += width[++shown]
    for (r = 1; r <= kept; r++) {
        line = ""
        for (i = 1; i <= shown; i++) line = line sprintf("%" width[i] "s", cell[r, i])
        print line
    }
    if (shown < n_column) printf "  ... %d columns more\n", n_column - shown
}
function leave() {
    if (table == "") return
    if (table == show) {
        print_rows()
        if (rows > 21) printf "  ... %d rows more\n", rows - 21
    } else {
        others = others (others == "" ? "" : ", ") table " (" rows - 1 ")"
    }
    table = ""
}
function keep_stray(line) { if (++strays <= 20) stray[strays] = line }
NF == 0 { leave(); next }
/^#/ {
    text = substr($0, 3)
    if (table == "") { table = text; rows = n_cell = 0; if (table == show) print table ":" }
    else if (table == show) print "  (" text ")"
    next
}
table == "" || rows > 0 && split($0, field, "\t") != n_cell { keep_stray($0); next }
{
    if (rows == 0) n_cell = split($0, field, "\t")
    rows++
    if (table != show || rows > 21) next
    n = split($0, field, "\t")
    if (rows == 1) n_column = n
    kept = rows
    for (i = 1; i <= n; i++) {
        text = is_number(field[i]) ? sprintf("%.6g", field[i]) : field[i]
        cell[rows, i] = text
        if (rows == 1) width[i] = 14
        if (length(text) + 2 > width[i]) width[i] = length(text) + 2
    }
}
function print_others(    n, word, line, i) {
    n = split("Other tables (rows): " others, word, " ")
    line = ""
    for (i = 1; i <= n; i++) {
        if (length(line) + length(word[i]) > 76) { print line; line = "  " word[i] }
        else line = line (line == "" ? "" : " ") word[i]
    }
    print line
}
END {
    leave()
    if (others != "") print_others()
    if (strays) print "Lines on stdout that belong to no table:"
    for (r = 1; r <= strays && r <= 20; r++) print "  " stray[r]
    if (strays > 20) print "  ... " strays - 20 " more"
}
