# names.awk - the names that a C file declares at file scope.
#
#     awk -f tests/tools/names.awk FILE...
#
# prints them, "macro NAME" or "name NAME" on a line, and not those of what is
# included.  own.awk asks it for those of a solution and of its checks.

BEGIN {
    split("auto const double enum extern float int long return short signed " \
          "sizeof static struct typedef union unsigned void volatile", all, " ")
    for (k in all) keyword[all[k]] = 1
    said["name", "main"] = 1
    for (k = 1; k < ARGC && !slug; k++) visit(ARGV[k], "alone")
}

# What is declared there goes to ours[]; the files that it includes are known.
function names_of_solution(file) { visit(file, "ours") }

# What is declared there, and in whatever it includes that the solution does not,
# is renamed from here on; macros of these names end.
function names_of_checks(file,    line, word) {
    while ((getline line < "tests/checks/names.h") > 0)
        if (split(line, word, " ") == 3) said["name", word[2]] = 1
    visit(file, "checks")
}

function say(kind, name, scan) {
    if (scan == "ours") {
        if (name != "main") ours[name]
        return
    }
    if (said[kind, name]++) return
    if (scan == "alone") print kind, name
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
function visit(file, scan,    line, more, part, k, n, of, text, lines) {
    if (file == "" || file in visited) return
    visited[file] = 1
    n = lines = 0
    while ((getline line < file) > 0) {
        if (!scan && !index(line, "#")) continue
        while (line ~ /\\$/ && (getline more < file) > 0)
            line = substr(line, 1, length(line) - 1) " " more
        if (line !~ /^[ \t]*#/) {
            if (scan) text[++lines] = line
        } else if (line ~ /^[ \t]*#[ \t]*include[ \t]*"/) {
            split(line, part, "\"")
            of[++n] = part[2]
        } else if (scan && sub(/^[ \t]*#[ \t]*define[ \t]+/, "", line)) {
            match(line, /^[A-Za-z_0-9]+/)
            say("macro", substr(line, 1, RLENGTH), scan)
        }
    }
    close(file)
    begin_declarations()
    for (k = 1; k <= lines; k++) declared(text[k], scan)
    for (k = 1; k <= n && scan != "alone"; k++)
        visit(found(file, of[k]), scan == "checks" ? scan : "")
}

# The line without comments, and each string or character in it a quote.
function bare(line,    left, at) {
    left = ""
    for (;;) {
        if (comment) {
            if (!(at = index(line, "*/"))) return left
            line = substr(line, at + 2)
            comment = 0
        }
        if (!match(line, /"([^"\\]|\\.)*"|'([^'\\]|\\.)*'|\/\*/))
            return left line
        at = substr(line, RSTART, 1)
        left = left substr(line, 1, RSTART - 1) (at == "/" ? " " : " \" ")
        line = substr(line, RSTART + RLENGTH)
        comment = at == "/"
    }
}

# At file scope a declared name stands before one of ( [ = , ;  A tag stands
# before the { of its members, wherever that is; an enumerator behind the { or a
# comma of its list.
function begin_declarations() {
    comment = tag = depth = list = value = pointer = inner = 0
    name = before = ""
}
function declared(line, scan,    part, n, t, token, ends) {
    if (comment || line ~ /["'\/]/) line = bare(line)
    gsub(/[^A-Za-z0-9_ \t]/, " & ", line)
    n = split(line, part, " ")
    for (t = 1; t <= n; t++) {
        token = part[t]
        if (token ~ /^[A-Za-z_]/) {
            tag = before ~ /^(struct|union|enum)$/
            name = token
            if (list && inner == depth && (before == "{" || before == ","))
                say("name", name, scan)
            if (pointer && !(name in keyword)) {
                say("name", name, scan)
                pointer = 0
            }
            if (name == "enum" && depth == 0) list = 1
            before = name
            continue
        }
        ends = depth == 0 && !value && index("([=,;", token)
        if (token == "{" && tag) ends = 1
        if (ends && name != "" && !(name in keyword) && name !~ /^_/)
            say("name", name, scan)
        name = ""
        if (token == "\"") continue
        if (token == "*" && before == "(" && depth == 1) pointer = 1
        if (depth == 0 && token == "=") value = 1
        if (depth == 0 && (token == "," || token == ";")) value = 0
        if (index("({[", token)) {
            depth++
            if (list && token == "{" && !inner) inner = depth
            else if (depth == 1) list = 0
        }
        if (index(")}]", token)) {
            depth--
            if (depth == 0 && list) list = inner = 0
        }
        if (depth == 0 && token == "}") value = 0
        before = token
    }
}
