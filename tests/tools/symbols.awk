# symbols.awk - symbols of a chapter that the notation does not have.
#
#     awk -f tests/tools/symbols.awk workbook.md lessons/*.md
#
# prints "lessons/NN_slug.md: SYMBOL", and "notation: ..." where a row is wrong.
#
# The table under "## Notation" has in its first column symbols between dollars
# and in its second the lessons where they mean what the row says: "all", or
# "3 to 8, 22", which goes before "all".  Two rows for one lesson must not begin
# a formula of theirs with the same symbol and index.
#
# A symbol is a letter or a Greek one, with its hat or the like, without what is
# below or above it: indices and exponents are not looked at.  Nor are numbers
# of their own (pi, e^x), O(h), the d of dx, and names in \mathrm or \text.  What
# a chapter uses in one place and says there may be named in the chapter, as in
#
#     <!-- symbols: C \hat N -->
#
# if it is used, and if no row has it for this lesson.

BEGIN {
    n = split("alpha beta gamma delta epsilon varepsilon zeta eta theta " \
        "vartheta iota kappa lambda mu nu xi rho sigma tau upsilon phi " \
        "varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi " \
        "Omega", name, " ")
    for (i = 1; i <= n; i++) greek["\\" name[i]] = 1
}

# The length of what stands at the beginning: {...}, a command, or a character.
function group(text,    i, depth) {
    if (match(text, /^\\[A-Za-z]+ */)) return RLENGTH
    if (text !~ /^\{/) return 1
    for (i = 1; i <= length(text); i++) {
        depth += (substr(text, i, 1) == "{") - (substr(text, i, 1) == "}")
        if (depth == 0) return i
    }
    return length(text)
}

# found[1..n_found] := the symbols of a formula
function symbols(text,    c, command, before) {
    n_found = 0
    gsub(/\\(mathrm|text|begin|end)\{[^}]*\}|L\^2/, " ", text)
    while (text != "") {
        c = substr(text, 1, 1)
        if (c ~ /[_^]/) {
            text = substr(text, 2)
            text = substr(text, 1 + group(text))
        } else if (match(text, /^\\(hat|bar|tilde|mathcal) *\{?\\?[A-Za-z]+/)) {
            command = substr(text, 1, RLENGTH)
            text = substr(text, RLENGTH + 1)
            gsub(/[ {]/, "", command)
            if (command !~ /\\[a-z]+\\/ && match(command, /^\\(hat|bar|tilde)/)) {
                # \hatFF is a hat on the first letter only
                text = substr(command, RLENGTH + 2) text
                command = substr(command, 1, RLENGTH + 1)
            }
            found[++n_found] = command
        } else if (match(text, /^\\[A-Za-z]+/)) {
            command = substr(text, 1, RLENGTH)
            text = substr(text, RLENGTH + 1)
            if (command in greek) found[++n_found] = command
        } else {
            if (c ~ /[A-Za-z]/ && !(c == "e" && text ~ /^e\^/) &&
                !(c == "d" && text ~ /^d[A-Za-z\\(]/) &&
                !(c == "O" && text ~ /^O\(/))
                found[++n_found] = c
            text = substr(text, 2)
        }
    }
}

# in_scope[lesson] := 1 for every lesson of "all" or of "3 to 8, 22"
function read_scope(text,    n, part, range, i, k) {
    split("", in_scope)
    if (text == "all") { in_scope["all"] = 1; return }
    n = split(text, part, /, */)
    for (i = 1; i <= n; i++) {
        if (part[i] !~ /^[0-9]+( to [0-9]+)?$/) {
            print "notation: no lessons: " text
            continue
        }
        split(part[i], range, " to ")
        for (k = range[1] + 0; k <= (range[2] ? range[2] : range[1]) + 0; k++)
            in_scope[k] = 1
    }
}

function read_row(row,    cell, n, part, i, k, lesson, key) {
    split(row, cell, / *\| */)
    read_scope(cell[3])
    n = split(cell[2], part, "$")
    for (i = 2; i <= n; i += 2) {
        symbols(part[i])
        key = part[i]
        sub(/[=<:(,].*/, "", key)
        for (lesson in in_scope) {
            if ((key, lesson) in row_of)
                print "notation: " key " has two rows for lesson " lesson
            row_of[key, lesson] = 1
            for (k = 1; k <= n_found; k++) has[found[k], lesson] = 1
            for (k = 1; k <= n_found; k++) has[found[k], "any"] = 1
        }
    }
}

function use(formula,    k) {
    symbols(formula)
    for (k = 1; k <= n_found; k++) used[found[k]] = 1
}

# The chapter is read: what does it use that it may not?
function judge(    s, n, part, i) {
    n = split(own, part, " ")
    for (i = 1; i <= n; i++) {
        if (!(part[i] in used)) print chapter ": " part[i] " is not used"
        else if ((part[i], lesson) in has) print chapter ": " part[i] " has a row"
        delete used[part[i]]
    }
    for (s in used)
        if (!((s, lesson) in has) && !((s, "all") in has)) print chapter ": " s
    split("", used)
    own = ""
}

FNR == 1 {
    if (chapter != "") judge()
    chapter = FILENAME == ARGV[1] ? "" : FILENAME
    lesson = "any"
    if (match(chapter, /[0-9][0-9]_/))
        lesson = substr(chapter, RSTART, 2) + 0
    math = fence = 0
}
chapter == "" {
    if (/^## /) notation = /^## Notation/
    if (notation && /^\| .*\$/) read_row($0)
    next
}
/^ *```/ {
    math = /```math/
    fence = !fence
    next
}
fence {
    if (math) use($0)
    next
}
/^<!-- symbols: .* -->$/ {
    own = own " " $0
    gsub(/<!-- symbols: | -->/, "", own)
    gsub(/\\(hat|bar|tilde|mathcal) /, "&\001", own)
    gsub(/ \001/, "", own)
    next
}
{
    gsub(/<!--[^>]*-->|`[^`]*`/, "")
    n_part = split($0, part, /\$+/)
    for (p = 2; p <= n_part; p += 2) use(part[p])
}
END { if (chapter != "") judge() }
