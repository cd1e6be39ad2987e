# mutants.awk - small mistakes in a program, one in a line.
#
#     awk -f tests/tools/mutants.awk -v seed=1 FILE
#
# prints "LINE<tab>GROUP<tab>TEXT", the text that line would have, in an order
# that the seed decides and that takes the groups in turn.  A group is a slot; in
# a file without slots (common/) every function is one.
#
# One operator, constant, index, name, order of arguments or statement is
# changed; what does not compile is for the caller to leave out.  A statement is
# taken away by `if (0)` before it.  What gives memory back stays as it is: that
# changes no result, and valgrind looks for it.  Nor does more memory than is
# needed change any.

# Whether the line is code, with comments and strings blanked.
function code_of(line,    out, i, c, two) {
    out = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        two = substr(line, i, 2)
        if (comment) {
            if (two == "*/") { comment = 0; out = out " "; i++ }
            c = " "
        } else if (quote != "") {
            if (c == "\\") { out = out " "; i++ }
            else if (c == quote) quote = ""
            c = " "
        } else if (two == "/*") {
            comment = 1; out = out " "; i++; c = " "
        } else if (c == "\"" || c == "'") {
            quote = c; c = " "
        }
        out = out c
    }
    return out
}

# Lines FNR with `length_` characters at `at` replaced.
function mutant(at, length_, new,    text) {
    text = substr(line, 1, at - 1) new substr(line, at + length_)
    if (text == line || ((FNR, text) in seen)) return
    seen[FNR, text] = 1
    many[group]++
    made[group, many[group]] = FNR "\t" group "\t" text
}

function constant(at, n, number) {
    if (number ~ /^[0-9]+$/) {
        mutant(at, n, number + 1)
        if (number > 0) mutant(at, n, number - 1)
    } else if (number ~ /^0\.0*$/) {
        mutant(at, n, "1.0")
    } else {
        mutant(at, n, "(2.0 * " number ")")
        mutant(at, n, "(0.5 * " number ")")
        mutant(at, n, "0.0")
        if (number ~ /e-/) mutant(at, n, "(1e3 * " number ")")
    }
}

function swaps(code,    at, rest, pair, first, second, comma, n) {
    rest = code
    at = 0
    while (match(rest, /[A-Za-z0-9_.]+, *[A-Za-z0-9_.]+/)) {
        pair = substr(rest, RSTART, RLENGTH)
        n = RSTART
        match(pair, /, */)
        first = substr(pair, 1, RSTART - 1)
        second = substr(pair, RSTART + RLENGTH)
        comma = substr(pair, RSTART, RLENGTH)
        if (substr(rest, n + length(pair), 1) ~ /[,)}]/ &&
            substr(rest, n - 1, 1) ~ /[ ({]/)
            mutant(at + n, length(pair), second comma first)
        at += n + length(first)
        rest = substr(code, at + 1)
    }
}

function operators(code,    i, n, c, two, rest, word, before, other) {
    before = ""
    for (i = 1; i <= length(code); i++) {
        rest = substr(code, i)
        two = substr(rest, 1, 2)
        c = substr(rest, 1, 1)
        if (c == " ") continue
        if (match(rest, /^[0-9]*\.?[0-9]+\.?[0-9]*([eE][-+]?[0-9]+)?/)) {
            n = RLENGTH
            word = substr(rest, 1, n)
            if (substr(code, 1, i - 1) !~ /allocate\($/)
                constant(i, n, word)
            else if (word > 1)
                mutant(i, n, word - 1)
            i += n - 1
            before = "0"
            continue
        }
        if (match(rest, /^[A-Za-z_][A-Za-z0-9_]*/)) {
            word = substr(rest, 1, RLENGTH)
            n = RLENGTH
            if (word in instead) mutant(i, n, instead[word])
            if ((group, word) in next_name && before !~ /^(\.|->)$/)
                mutant(i, n, next_name[group, word])
            i += n - 1
            before = "a"
            continue
        }
        if (two ~ /^(->|<<|>>)$/) { i++; before = two; continue }
        if (two in replaced) {
            split(replaced[two], other, " ")
            mutant(i, 2, other[1])
            if (2 in other) mutant(i, 2, other[2])
            i++
            before = two
            continue
        }
        if (two == "++" || two == "--") {
            if (code !~ /for \(/) mutant(i, 2, two == "++" ? "--" : "++")
            i++
            before = two
            continue
        }
        if (c in replaced && !(c == "*" && before !~ /^[a0)\]]$/)) {
            split(replaced[c], other, " ")
            mutant(i, 1, other[1])
            if (2 in other) mutant(i, 1, other[2])
        }
        if (c == "!") mutant(i, 1, "")
        if (c == "[" && substr(rest, 2) !~ /^ *[0-9]+ *\]/ && before == "a") {
            mutant(i, 1, "[1 + ")
            mutant(i, 1, "[-1 + ")
        }
        before = c
    }
}

# The names that a slot has to work with, in a ring: one is taken for the next.
function names(list,    n, i, word) {
    gsub(/[^A-Za-z0-9_ ]/, " ", list)
    n = split(list, word, " ")
    for (i = 1; i <= n; i++) next_name[group, word[i]] = word[i % n + 1]
}

# Whether a statement begins on this line of code.
function begins(code) {
    return open == 0 && last ~ /(^|[;{})]|else|:)$/ &&
        code ~ /^ *[A-Za-z_*]/ && code !~ /^ *(for \(.*\) )?([a-z_0-9]*_)?free\(/ && code !~ /^ *(else|case|default|enum|struct|static|const|UNROLL|typedef|int|double|size_t|mat2)[ :]/
}

function look(code,    i, c, bare) {
    if (code !~ /^ *for \(.*\) [a-z_0-9]*free\(/) {
        operators(code)
        swaps(code)
    }
    if (begins(code)) {
        match(code, /^ */)
        mutant(RLENGTH + 1, 0, "if (0) ")
    }
    for (i = 1; i <= length(code); i++) {
        c = substr(code, i, 1)
        open += (c == "(") - (c == ")")
    }
    bare = code
    gsub(/ +$/, "", bare)
    if (bare != "") last = bare
}

function random(n) {
    state = (state * 16807) % 2147483647
    return 1 + state % n
}

BEGIN {
    replaced["+="] = "-= ="; replaced["-="] = "+= ="
    replaced["*="] = "/= ="; replaced["/="] = "*= ="
    replaced["<="] = "< >"; replaced[">="] = "> <"
    replaced["=="] = "!="; replaced["!="] = "=="
    replaced["&&"] = "||"; replaced["||"] = "&&"
    replaced["<"] = "<= >"; replaced[">"] = ">= <"
    replaced["+"] = "-"; replaced["-"] = "+"
    replaced["*"] = "/"; replaced["/"] = "*"; replaced["%"] = "*"
    instead["fabs"] = ""; instead["sqrt"] = ""
    instead["fmax"] = "fmin"; instead["fmin"] = "fmax"
    instead["isfinite"] = "!isfinite"; instead["break"] = "continue"
    instead["sin"] = "cos"; instead["cos"] = "sin"
}
FNR == 1 { slots = 0 }
{ text[FNR] = $0; if (/\/\* SLOT [0-9]+[a-z]\(/) slots = 1 }
END {
    lines = FNR
    inside = 0; comment = 0; quote = ""; last = ""; open = 0
    for (FNR = 1; FNR <= lines; FNR++) {
        line = text[FNR]
        if (slots && match(line, /\/\* SLOT [0-9]+[a-z]\(/)) {
            group = substr(line, RSTART + 8, RLENGTH - 9)
            groups[++n_group] = group
            inside = 1; last = ""; open = 0
            list = substr(line, RSTART + RLENGTH)
            sub(/\).*/, "", list)
            names(list)
        }
        if (slots && line ~ /\/\* END [0-9]+[a-z] \*\//) inside = 0
        code = line ~ /^ *#/ ? "" : code_of(line)
        if (!slots) {
            if (line ~ /^[a-z_A-Z].*\(/) name = FNR
            if (line ~ /^\{/) {
                group = name; groups[++n_group] = group
                inside = 1; last = ""; open = 0
                continue
            }
            if (line ~ /^\}/) inside = 0
        }
        if (inside) look(code)
    }
    state = 1 + (seed * 7919 + 104729) % 2147483646
    for (i = 0; i < 9; i++) random(2)
    for (g = 1; g <= n_group; g++) { # shuffle each group
        group = groups[g]
        for (i = many[group]; i > 1; i--) {
            j = random(i)
            swap = made[group, i]
            made[group, i] = made[group, j]
            made[group, j] = swap
        }
    }
    for (i = 1; left != 0 || i == 1; i++) {
        left = 0
        for (g = 1; g <= n_group; g++)
            if (i <= many[groups[g]]) { print made[groups[g], i]; left = 1 }
    }
}
