# contract.awk - what the checks of a lesson know of a program.
#
#     awk -f tests/tools/contract.awk solutions/NN_slug.c > HEADER
#     awk -f tests/tools/contract.awk calls=1 CHECKS.s solutions/NN_slug.c > CALLS
#
# The header is the solution without the bodies of its functions: f() is declared
# under the linker's name program_f (program.h).  The calls are those of them that
# the compiled checks name: a line "f, tab, definition of program_f, which calls
# %", to be set behind a program, whose functions are its own.

BEGIN { used["main"] }
FNR == 1 { solution = FILENAME ~ /\.c$/
           if (solution && !calls) print "#pragma GCC system_header" }
!solution { # the checks, as the compiler writes them
    while (match($0, /program_[A-Za-z_0-9]+/)) {
        used[substr($0, RSTART + 8, RLENGTH - 8)]
        $0 = substr($0, RSTART + RLENGTH)
    }
    next
}
inside { inside = !/^}/; next }
/^[a-z]/ && !head { text = ""; head = 1 }
head {
    text = text $0
    if (!/[{;]/) { text = text "\n"; next }
    head = 0
    match(text, /[({=;]/)
    if (substr(text, RSTART, 1) == "(" && text ~ /\)[ \n]*\{/) {
        inside = !/}$/
        declare(substr(text, 1, index(text, "{") - 1), RSTART)
        next
    }
    $0 = text
}
!calls

function declare(text, open,    name, type, given) {
    if (sub(/^static /, "", text)) open -= 7
    sub(/[ \n]*$/, "", text)
    match(substr(text, 1, open - 1), /[A-Za-z_0-9]+$/)
    name = substr(text, RSTART, RLENGTH)
    type = substr(text, 1, RSTART - 1)
    given = substr(text, open + 1, length(text) - open - 1)
    if (!calls && name != "main") print text " AS_PROGRAM(" name ");"
    if (!calls || !(name in used)) return
    gsub(/\n */, " ", given)
    print name "\t" type "program_" name "(" given ") { " \
        (type == "void " ? "" : "return ") "%(" names_of(given) "); }"
}
# the names of the parameters, with commas
function names_of(given,    part, n, k, depth, c, name, all) {
    n = length(given)
    for (k = 1; k <= n; k++) {
        c = substr(given, k, 1)
        depth += (c == "(") - (c == ")")
        part = part (c == "," && depth == 0 ? "\n" : c)
    }
    n = split(part, name, "\n")
    for (k = 1; k <= n && given != "void"; k++) {
        if (match(name[k], /\(\*[a-z_A-Z0-9]+/)) # a function
            name[k] = substr(name[k], RSTART + 2, RLENGTH - 2)
        gsub(/\[.*/, "", name[k])
        match(name[k], /[A-Za-z_0-9]+$/)
        all = all (k > 1 ? ", " : "") substr(name[k], RSTART)
    }
    return all
}
