# show.awk - named tables for the eye.
#
#     awk -f tests/tools/show.awk -v show=NAME FILE
#
# The table NAME is printed, aligned and to six digits, at most 20 rows of it;
# of the others the name and the number of rows.
function leave() {
    if (table == "") return
    if (table == show) {
        if (rows > 21) printf "  ... %d rows more\n", rows - 21
    } else {
        others = others (others == "" ? "" : ", ") table " (" rows - 1 ")"
    }
    table = ""
}
NF == 0 { leave(); next }
/^#/ {
    text = substr($0, 3)
    if (table == "") { table = text; rows = 0; if (table == show) print table ":" }
    else if (table == show) print "  (" text ")"
    next
}
{
    rows++
    if (table != show || rows > 21) next
    line = ""
    n = split($0, field, "\t")
    for (i = 1; i <= n; i++)
        line = line sprintf(rows == 1 ? "%14s" : "%14.6g", field[i])
    print substr(line, 1, 100)
}
END {
    leave()
    if (others == "") exit
    n = split("Other tables (rows): " others, word, " ")
    line = ""
    for (i = 1; i <= n; i++) {
        if (length(line) + length(word[i]) > 76) { print line; line = "  " word[i] }
        else line = line (line == "" ? "" : " ") word[i]
    }
    print line
}
