# program.awk - a preprocessed program, with what its checks call behind it.
#
#     awk -v program=FILE -v into=HEADER -f tests/tools/program.awk CONTRACT CALLS
#         PREPROCESSED
#
# CONTRACT and CALLS are those of contract.awk.  The last line of the program is
# "program_has" and the names of these functions, where macros of the program have
# put what it means by them.  No macro is left after that.  What is not a header may
# not be included, however its path is spelt: a line marker with 1 begins a file.  A
# link is none, nor is a second name of a solution's file.
# Where a struct has other members than in the contract, the program's contract is
# left in HEADER.  The status is 1 for what is refused, and where a function of the
# contract is missing.

BEGIN { FS = "\t" }
FNR == 1 { file++ }
file == 1 { contract = contract $0 "\n" }
file == 1 { next }
file == 2 { name[++n] = $1; call[n] = $2; missing[$1]; next }
FNR == 1 { # the structs of the contract: where their text begins, and ends
    for (rest = contract; match(rest, /\nstruct [A-Za-z_0-9]+ \{[^}]*\}/); ) {
        text = substr(rest, RSTART + 1, RLENGTH - 1)
        split(text, word, " ")
        members[word[2]] = text
        rest = substr(rest, RSTART + RLENGTH)
    }
}
/^# [0-9]+ ".*" 1( 3)?( 4)?$/ {
    path = $0
    gsub(/^# [0-9]+ "|" 1[ 134]*$/, "", path)
    own = path == program || path == "./" program || path ~ /^<.*>$/
    if (!own && (path !~ /\.h$/ || path ~ /^\/(dev|proc)\// || is_link(path))) {
        print "refused: it includes what is no header, " path > "/dev/stderr"
        exit refused = 1
    }
}
$1 ~ /^program_has/ { behind = $0; next }
{ print }
/^# / {
    depth += / 1[ 134]*$/
    depth -= / 2[ 134]*$/
}
/^#/ { next }
depth == 1 {
    for (f in missing)
        if (index($0, f) && $0 ~ "(^|[^A-Za-z_0-9])" f "([^A-Za-z_0-9]|$)")
            delete missing[f]
}
struct == "" && match($0, /struct[ ]+[A-Za-z_0-9]+[ ]*(\{.*)?$/) {
    struct = substr($0, RSTART)
    split(struct, word, /[^A-Za-z_0-9]+/)
    if (!(word[2] in members)) struct = ""
    else if (struct !~ /\}/) next
    else $0 = ""
}
struct != "" {
    struct = struct "\n" $0
    if (struct !~ /^struct +[A-Za-z_0-9]+[ \n]*(\{|$)/) struct = ""
    else if ((closed = gsub(/\}/, "}", struct)) && closed >= gsub(/\{/, "{", struct))
        changed(word[2], substr(struct, 1, match(struct, /\}[^}]*$/)))
}
# Only of what is neither the library's nor the system's.
function is_link(path) {
    if (path ~ /^(common|\/usr|\/opt|\/Applications|\/Library)\// && path !~ /\.\./)
        return 0
    if (path ~ /[^A-Za-z0-9_.+\/-]/) return 1
    return system("[ ! -L " path " ] && for f in solutions/*.c; do " \
        "[ ! " path " -ef $f ] || exit 1; done")
}
function changed(tag, text,    at) {
    struct = ""
    if (tokens(text) == tokens(members[tag])) return
    at = index(contract, "\n" members[tag])
    contract = substr(contract, 1, at) text substr(contract, at + 1 + \
        length(members[tag]))
    members[tag] = text
    other = 1
}
function tokens(text) {
    gsub(/\/\*([^*]|\*[^\/])*\*\//, " ", text)
    gsub(/[^A-Za-z0-9_ \n]/, " & ", text)
    gsub(/[ \n]+/, " ", text)
    return text
}
END {
    if (refused) exit 1
    split(behind, word, " ")
    for (k = 1; k <= n; k++) {
        print "# 1 \"the call of " name[k] "\" 3"
        if (word[k + 1] != name[k] && word[k + 1] ~ /^[A-Za-z_][A-Za-z_0-9]*$/) {
            delete missing[name[k]]
            name[k] = word[k + 1]
        }
        sub(/%/, name[k], call[k])
        print call[k]
    }
    for (f in missing) print "missing: " f > "/dev/stderr"
    for (f in missing) exit 1
    if (other) printf "%s", contract > into
}
