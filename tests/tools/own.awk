# own.awk - what a preprocessed program has of its own.
#
#     cc -E PROGRAM | awk -f tests/tools/own.awk
#
# prints a line for each
#   refused WHY    what no lesson needs, and no judge can allow
#   own NAME       defined at file scope, and in none of the headers
#   linked NAME    a function that the linker sees, and a header of the system
#                  names too
#   word NAME      any word of the program itself
# A name that is declared only, as that of a function of the system, is none of
# these.  A line marker with 1 begins a file that is included, 2 goes back.

/^# / {
    if (/ 1( 3| 4)*$/) {
        if (match($0, /(^|[\/"])solutions\/[^\/"]*"/))
            refused["it includes a solution"]
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
        if (storage != "static") linked[called]
    } else if (token == "{" && last ~ /^[A-Za-z_]/) {
        if (before ~ /^(struct|union|enum)$/) defined[last]
        listing = last == "enum" || before == "enum"
    }
    if (index("({[", token)) inside = 1
    if (token == ";") begin()
    before = last
    last = token
}

END {
    for (why in refused) print "refused " why
    for (name in word) print "word " name
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
        if (!(name in named)) print "own " name
        else if (name in linked && named[name]) print "linked " name
    }
}
