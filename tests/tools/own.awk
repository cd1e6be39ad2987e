# own.awk - the header that names.sh makes, from what a preprocessed program has
# of its own.
#
#     cc -E PROGRAM | PROGRAM=... [SYSTEM=...] awk -f tests/tools/names.awk \
#         -f tests/tools/own.awk -v slug=NN_slug > HEADER
#
# The program is read first, and has
#   refused[WHY]   what no lesson needs, and no judge can allow
#   only[NAME]     defined at file scope, and in none of the headers
#   global[NAME]   a function that the linker sees; a header of the system may
#                  name it, too
#   word[NAME]     any word of the program itself
# A name that is declared only, as that of a function of the system, is none of
# these.  A line marker with 1 begins a file that is included, 2 goes back.
#
# The status is 1 for what is refused, and 3 when the program has macros of its
# own: then it is asked for once more, with SYSTEM, a file of the system's.

/^# / {
    if (/ 1( 3| 4)*$/) {
        if (/\.c" 1( 3| 4)*$/ && index($0, "\"" ENVIRON["PROGRAM"] "\"") == 0)
            refused["it includes another program"]
        depth++
        # one that is found by "..." is the workbook's, or the student's
        system_[depth] = / 3( 4)?$/ || $0 !~ /"common\//
    } else if (/" 2( 3| 4)*$/) {
        depth--
    }
    next
}
/constructor/ {
    text = $0
    gsub(/"([^"\\]|\\.)*"/, "", text)
    if (text ~ /(^|[^A-Za-z0-9_])_*constructor_*([^A-Za-z0-9_]|$)/)
        refused["it has a constructor, which runs before main()"]
}
/section/ && /(^|[^A-Za-z0-9_])_*section_*[ \t]*\([ \t]*"/ {
    refused["it puts something into a section of the object file"]
}
depth > 0 {
    if ($0 == "") next
    header[++n_line] = $0
    is_system[n_line] = system_[depth]
    next
}
/(^|[^A-Za-z0-9_])(asm|__asm__|__asm)([^A-Za-z0-9_]|$)/ {
    text = $0
    gsub(/"([^"\\]|\\.)*"/, "", text)
    if (text ~ /(^|[^A-Za-z0-9_])(asm|__asm__|__asm)([^A-Za-z0-9_]|$)/)
        refused["it has a line of assembler"]
}
!/^[ \t]*#/ { own() }

# At depth 0 a declared name stands before one of ( [ = , ;  A tag stands before
# the { of its members, an enumerator in the { } of its enum.
function own(    line, token) {
    line = $0
    gsub(/"([^"\\]|\\.)*"|'([^'\\]|\\.)*'/, "0", line)
    gsub(/[^A-Za-z0-9_ \t]/, " & ", line)
    n_token = split(line, part, " ")
    for (t = 1; t <= n_token; t++) {
        token = part[t]
        if (token ~ /^[A-Za-z_]/) word[token]
        if (inside > 0) within(token)
        else at_file_scope(token)
    }
}
function within(token) {
    if (index("({[", token)) inside++
    else if (index(")}]", token)) inside--
    if (listing && inside == 1 && token ~ /^[A-Za-z_]/ && last ~ /^[{,]$/)
        defined[token]
    last = token
    if (inside > 0) return
    listing = 0
    if (token == "}" && body) begin()
}
function begin() { # a declaration
    storage = name = called = ""
    body = value = 0
}
function at_file_scope(token) {
    if (token ~ /^(static|extern|typedef)$/) storage = token
    if (index("([=,;", token) && !value && last ~ /^[A-Za-z_]/ &&
        last !~ /^(__|_(Al|At|B|C|G|I|N|S|T)[a-z])/) {
        if (token == "(") { if (called == "") called = last }
        else if (storage != "extern") defined[last]
    }
    if (token == "=") value = 1
    if (token == ",") value = 0
    if (token == "{" && last == ")" && called != "") {
        body = 1
        defined[called]
        if (storage != "static") global[called]
    } else if (token == "{" && last ~ /^[A-Za-z_]/) {
        if (before ~ /^(struct|union|enum)$/) defined[last]
        listing = last == "enum" || before == "enum"
    }
    if (index("({[", token)) inside = 1
    if (token == ";") begin()
    before = last
    last = token
}

function find_own(    all, k, n_token, part, t, name, candidates, named) {
    split("auto break case char const continue default do double else enum extern" \
          " float for goto if inline int long main register restrict return short" \
          " signed sizeof static struct switch typedef union unsigned void" \
          " volatile while", all, " ")
    for (k in all) delete defined[all[k]]
    for (name in defined) candidates++
    for (k = 1; k <= n_line && candidates; k++) {
        n_token = split(header[k], part, /[^A-Za-z0-9_]+/)
        for (t = 1; t <= n_token; t++)
            if (part[t] in defined) named[part[t]] = named[part[t]] || is_system[k]
    }
    for (name in defined) {
        if (!(name in named)) only[name]
        else if (!(name in global && named[name])) delete defined[name]
    }
}

# The names that the program defines or undefines as macros, macro[NAME]; `mine`
# are those of them that the solution does not.  What a macro stands for whose
# name is the lesson's keeps its name as well: by it alone there is a function of
# the lesson, which is kept[NAME].
function find_macros(solution,    line, name, also, k, n, text) {
    while ((getline line < solution) > 0)
        if (name = defines(line)) also[name]
    close(solution)
    while ((getline line < ENVIRON["PROGRAM"]) > 0) {
        if (!(name = defines(line))) continue
        text[++n] = line
        macro[name]
        if (name in also) continue
        mine[name]
        if (name in ours && !(name in word)) kept[name]
    }
    close(ENVIRON["PROGRAM"])
    for (k = 1; k <= n; k++)
        for (name in kept)
            if (text[k] ~ "^[ \t\r\f\v]*#[ \t\r\f\v]*define[ \t\r\f\v]*" name)
                keep_words(text[k])
}
function defines(line) {
    if (!sub(/^[ \t\r\f\v]*#[ \t\r\f\v]*(define|undef)[ \t\r\f\v]+/, "", line))
        return ""
    match(line, /^[A-Za-z_][A-Za-z_0-9]*/)
    return substr(line, 1, RLENGTH)
}
function keep_words(line,    part, n) {
    sub(/^[ \t\r\f\v]*#[ \t\r\f\v]*define[ \t\r\f\v]*/, "", line)
    n = split(line, part, /[^A-Za-z_0-9]+/)
    while (n) ours[part[n--]]
}

END {
    for (why in refused) {
        print "refused: " why > "/dev/stderr"
        exit 1
    }
    theirs = ENVIRON["SYSTEM"]
    find_own()
    names_of_solution("solutions/" slug ".c")
    find_macros("solutions/" slug ".c")
    for (name in mine) if (theirs == "") exit 3
    print "#ifdef main"
    for (name in defined) {
        if (name in ours || name in macro) delete only[name]
        else if (name in only) print "#define " name " program_own_" name
        else print "#pragma redefine_extname " name " program_own_" name
    }
    print "#else"
    for (name in only) print "#undef " name
    for (name in mine) if (!(name in kept)) print "#undef " name
    while (theirs != "" && (getline line < theirs) > 0) {
        name = defines(line)
        if (name in mine && !(name in kept)) print line
    }
    names_of_checks("tests/checks/" slug ".c")
    print "#endif"
}
