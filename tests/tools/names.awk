# names.awk - the names that a C file declares at file scope.
#
#     awk -f tests/tools/names.awk -v slug=NN_slug tests/checks/NN_slug.c
#
# prints a header: what is declared there, and in whatever it includes that the
# solution does not, is renamed from here on; macros of these names end.
#
#     awk -f tests/tools/names.awk solutions/NN_slug.c
#
# prints the names themselves, "macro NAME" or "name NAME" on a line, and not
# those of what is included.

BEGIN {
    split("auto const double enum extern float int long return short signed " \
          "sizeof static struct typedef union unsigned void volatile", all, " ")
    for (k in all) keyword[all[k]] = 1
    if (slug) visit("solutions/" slug ".c", "")
    while (slug && (getline line < "tests/checks/names.h") > 0)
        if (split(line, word, " ") == 3) said["name", word[2]] = 1
    said["name", "main"] = 1
    for (k = 1; k < ARGC; k++) if (ARGV[k] !~ /=/) visit(ARGV[k], "scan")
}

function say(kind, name) {
    if (said[kind, name]++) return
    if (!slug) print kind, name
    else {
        print "#undef " name
        if (kind == "name") print "#define " name " checks_own_" name
    }
}

# The file that FILE means by #include "NAME"; none of the judge's.
function found(file, name,    at, line) {
    sub(/[^\/]*$/, "", file)
    if (name ~ /^(program|judge)\.h$/) return ""
    while (name ~ /^\.\.\//) {
        sub(/^\.\.\//, "", name)
        sub(/[^\/]*\/$/, "", file)
    }
    at = file name
    if ((getline line < at) < 0) at = "common/" name
    close(at)
    return at
}

# Read FILE, and what it includes; look at its names when there is a `scan`.
function visit(file, scan,    line, text, more, part, k, n, of) {
    if (file == "" || file in visited) return
    visited[file] = 1
    n = 0
    while ((getline line < file) > 0) {
        while (line ~ /\\$/ && (getline more < file) > 0)
            line = substr(line, 1, length(line) - 1) " " more
        if (line ~ /^[ \t]*#[ \t]*include[ \t]*"/) {
            split(line, part, "\"")
            of[++n] = part[2]
        } else if (line ~ /^[ \t]*#/) {
            if (scan && sub(/^[ \t]*#[ \t]*define[ \t]+/, "", line)) {
                match(line, /^[A-Za-z_0-9]+/)
                say("macro", substr(line, 1, RLENGTH))
            }
        } else {
            text = text "\n" line
        }
    }
    close(file)
    if (scan) declared(text)
    for (k = 1; k <= n && slug; k++) visit(found(file, of[k]), scan)
}

# At file scope a declared name stands before one of ( [ = , ;  A tag stands
# before the { of its members, wherever that is; an enumerator behind the { or a
# comma of its list.
function declared(text,    word, mark, before, ends, tag, depth, list, value,
                  pointer, inner) {
    while (text != "") {
        if (match(text, /^[ \t\n]+/)) {
        } else if (match(text, /^\/\*/)) {
            RLENGTH = index(text, "*/") + 1
        } else if (match(text, /^"([^"\\]|\\.)*"/) ||
                   match(text, /^'([^'\\]|\\.)*'/)) {
            word = ""
        } else if (match(text, /^[A-Za-z_][A-Za-z_0-9]*/)) {
            tag = before ~ /^(struct|union|enum)$/
            word = substr(text, 1, RLENGTH)
            if (list && inner == depth && (before == "{" || before == ","))
                say("name", word)
            if (pointer && !keyword[word]) {
                say("name", word)
                pointer = 0
            }
            if (word == "enum" && depth == 0) list = 1
            before = word
        } else {
            RLENGTH = 1
            mark = substr(text, 1, 1)
            ends = depth == 0 && !value && index("([=,;", mark)
            if (mark == "{" && tag) ends = 1
            if (ends && word != "" && !keyword[word] && word !~ /^_/)
                say("name", word)
            if (depth == 0 && mark == "(" && text ~ /^\([ \t\n]*\*/) pointer = 1
            if (depth == 0 && mark == "=") value = 1
            if (depth == 0 && (mark == "," || mark == ";")) value = 0
            if (index("({[", mark)) {
                depth++
                if (list && mark == "{" && !inner) inner = depth
                else if (depth == 1) list = 0
            }
            if (index(")}]", mark)) {
                depth--
                if (depth == 0 && list) list = inner = 0
            }
            if (depth == 0 && mark == "}") value = 0
            before = mark
            word = ""
        }
        text = substr(text, RLENGTH + 1)
    }
}
