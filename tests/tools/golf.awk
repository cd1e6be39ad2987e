# golf.awk - lines that were saved where they should not be.
#
#     awk -f tests/tools/golf.awk FILES.c
#
# Prints "FILE:LINE: what" for
# - a test in the head of a `for` that is an `if`: one side of its `&&` names
#   neither what the head's third part changes nor anything that the body
#   assigns, steps, takes the address of, or hands to a call as it is;
# - a counter with both `/` and `%` in the body of its `for`: nested loops;
# - an array that begins inside what another one was allocated: `b = a + n`
#   within six lines of `a = allocate(`.
# These are guesses from names, statement by statement; comments and strings are
# left out.  A comment "one block: WHY" or "one index: WHY" on the line, or up to
# two lines before it, says why one stands.

function plain(s,   before, at) { # without strings and comments
    gsub(/\\./, "", s)
    gsub(/"[^"]*"|'[^']*'/, "0", s)
    while (1) {
        if (in_comment) {
            if (!(at = index(s, "*/"))) return ""
            s = substr(s, at + 2)
            in_comment = 0
        }
        if (!(at = index(s, "/*"))) return s
        before = substr(s, 1, at - 1)
        s = substr(s, at + 2)
        in_comment = 1
        if (!(at = index(s, "*/"))) return before
        s = before " " substr(s, at + 2)
        in_comment = 0
    }
}
function has(text, word) { return match(" " text " ", "[^A-Za-z0-9_.>]" word "[^A-Za-z0-9_]") }

# Does `text` change the variable `word`, or may it?
function changes(text, word) {
    return match(" " text, "[^A-Za-z0-9_.>]" word \
               "(\\[[^]]*\\])*((\\.|->)[a-z_A-Z0-9]+(\\[[^]]*\\])*)* *([-+*/|&]?=[^=]|\\+\\+|--)") ||
           match(" " text, "(\\+\\+|--|&)" word "[^A-Za-z0-9_]") ||
           match(" " text, "[(,] *" word "[,)]")
}
# Is there a name in `side` that `text` changes?
function moves(side, text,   word) {
    while (match(side, /[A-Za-z_][A-Za-z0-9_]*/)) {
        word = substr(side, RSTART, RLENGTH)
        side = substr(side, RSTART + RLENGTH)
        if (changes(text, word)) return 1
    }
    return 0
}
function excused(at, what,   k) {
    for (k = at; k >= at - 2 && k > 0; k--) if (index(raw[k], what)) return 1
    return 0
}
function say(at, what) { print file ":" at ": " what }

# The text from line `at`, place `from`, to where its statement ends; sets END.
function statement(at, from,   s, c, depth, braces, out, i) {
    depth = braces = 0
    out = ""
    for (; at <= n; at++) {
        s = line[at]
        for (i = from; i <= length(s); i++) {
            c = substr(s, i, 1)
            out = out c
            if (c == "(") depth++
            if (c == ")") depth--
            if (c == "{") braces++
            if (c == "}" && --braces <= 0 && depth == 0) return out
            if (c == ";" && depth == 0 && braces == 0) return out
        }
        out = out " "
        from = 1
    }
    return out
}

function look_at_for(at, from,   text, i, c, depth, head, body, part, k, side, m, name, rest) {
    text = statement(at, from)
    depth = 0
    for (i = index(text, "("); i <= length(text); i++) {
        c = substr(text, i, 1)
        if (c == "(") depth++
        if (c == ")" && --depth == 0) break
    }
    head = substr(text, index(text, "(") + 1, i - index(text, "(") - 1)
    body = substr(text, i + 1)
    split(head, part, ";")
    m = split(part[2], side, "&&")
    if (m > 1 && index(part[2], "(") == 0)
        for (k = 1; k <= m; k++)
            if (!moves(side[k], part[3] ";" body))
                say(at, "an if in the head of a for:" side[k])
    rest = part[3]
    while (match(rest, /[A-Za-z_][A-Za-z0-9_]*/)) {
        name = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        if (match(body, "[^A-Za-z0-9_.>*] *" name " / [A-Za-z0-9_(]") &&
            match(" " body, "[^A-Za-z0-9_.>]" name "( / [A-Za-z0-9_]+)? % ") &&
            !excused(at, "one index: "))
            say(at, "/ and % of the counter " name)
    }
}

function look(   i, k, at, s, t, name) {
    for (i = 1; i <= n; i++) {
        t = line[i]
        at = 0
        while (match(t, /(^|[^A-Za-z0-9_])for \(/)) {
            at += RSTART + RLENGTH - 1
            t = substr(t, RSTART + RLENGTH)
            look_at_for(i, at)
        }
        s = line[i]
        while (match(s, /[a-z_A-Z][A-Za-z0-9_]*((\.|->)[a-z_A-Z]+)? = [a-z_]*allocate\(/)) {
            name = substr(s, RSTART, RLENGTH)
            sub(/ = .*/, "", name)
            s = substr(s, RSTART + RLENGTH)
            first[name] = i
        }
        s = line[i]
        while (match(s, /([=,{] *)[a-z_A-Z][A-Za-z0-9_]*((\.|->)[a-z_A-Z]+)? \+ /)) {
            name = substr(s, RSTART, RLENGTH)
            s = substr(s, RSTART + RLENGTH)
            sub(/^[=,{] */, "", name)
            sub(/ \+ $/, "", name)
            if (name in first && i - first[name] <= 6) {
                if (!excused(i, "one block: ") && !excused(first[name], "one block: "))
                    say(i, "an array inside that of " name)
            }
        }
        if (line[i] ~ /^}/) for (k in first) delete first[k]
    }
    n = 0
}
FNR == 1 && NR > 1 { look() }
FNR == 1 { file = FILENAME; in_comment = 0; for (k in first) delete first[k] }
{ raw[++n] = $0; line[n] = plain($0) }
END { look() }
