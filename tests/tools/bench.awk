# bench.awk - the tables that `make bench` has measured, for what comes behind it:
# closing.awk or seconds.awk.
#
#     awk -f bench.awk -f closing.awk build/data/speed/*.tsv ...
#
# of(study, table, key, column) is a number, the key being the words and the n of
# its row; one that is not there (no LAPACK, no CHOLMOD) is `-`.
BEGIN { FS = "\t" }
FILENAME ~ /[.]md$/ { page[++pages] = $0; next } # of seconds.awk
/^# machine: / { machine[FILENAME] = substr($0, 12) }
FNR == 1 { n = split(FILENAME, part, "/"); study = part[n]
           sub(/[.]tsv$/, "", study); table = ""; head = 0 }
/^# / && table == "" { table = substr($0, 3); head = 0; next }
/^# PETSc/ { package = substr($0, 3) }
/^#/ { next }
NF == 0 { table = ""; next }
!head { head = 1; for (i in column) delete column[i]
        for (i = 1; i <= NF; i++) column[i] = $i
        columns = NF; next }
{ # value[study, table, key, column], the key being the words and n of a row
    key = ""
    for (i = 1; i <= columns; i++)
        if (is_key(column[i]))
            key = key (key == "" ? "" : " ") ($i ~ /^[0-9.]+$/ ? sprintf("%.10g", $i) : $i)
    for (i = 1; i <= columns; i++) value[study, table, key, column[i]] = $i
}
function is_key(name) {
    return name == "n" && table != "realtime" && table != "swing" ||
        name == "solver" || name == "method" || name == "line" ||
        table == "swing" && name == "systems" ||
        name == "scene" || name == "factors" || table == "elements" &&
        (name == "error" || name == "element" || name == "m")
}
function of(study, table, key, name,    cell) {
    cell = (study, table, key, name) in value ? value[study, table, key, name] : "-"
    return cell ~ /^-?[0-9.]/ ? cell + 0 : "-"
}
function least(a, b) { return a == "-" ? b : b == "-" ? a : a < b ? a : b }
function over(a, b) { return a == "-" || b == "-" || b == 0 ? "-" : a / b }
function gain(other, k, n) { # times that `k` takes longer than `other`
    return over(of("solvers", "solvers", k " " n, "step_ms"),
                of("solvers", "solvers", other " " n, "step_ms"))
}
