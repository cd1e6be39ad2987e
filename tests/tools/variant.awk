# variant.awk - known mistakes and equivalent programs, as replacements.
#
#     awk -f tests/tools/variant.awk -v list=mistake FILE           their names
#     awk -f tests/tools/variant.awk -v name=X -v get=why FILE      one field
#     awk -f tests/tools/variant.awk -v name=X FILE SOLUTION        the program
#
# FILE is tests/mistakes/NN_slug.txt, entries of the form
#
#     mistake: lift_forgotten          (or  equivalent: another_way)
#     caught-by: name_of_the_check     (mistakes only)
#     verdict: NONFINITE               (where it is not WRONG)
#     slot: 9c                         (where the verdict may name another slot
#                                       than that of the first line changed)
#     shows: no                        (where no run of the program shows it:
#                                       it is caught, but cannot be explained)
#     why: what the student is told, two lines or so;
#       a continuation is indented.
#     from:
#     ...lines of the solution, to the letter; they must occur exactly once...
#     to:
#     ...what stands there instead...
#     end
#
# Several from/to pairs in an entry are applied one after another.

FILENAME == ARGV[1] {
    if (!part && match($0, /^(mistake|equivalent): /)) {
        kind = substr($0, 1, RLENGTH - 2)
        entry = substr($0, RLENGTH + 1)
        if (list == kind) print entry
        mine = (entry == name)
        next
    }
    if ($0 == "from:") { part = "from"; if (mine) n++; next }
    if ($0 == "to:") { part = "to"; next }
    if ($0 == "end") { part = ""; field = ""; next }
    if (part && mine) text[n, part] = text[n, part] $0 "\n"
    if (part || !mine) next
    if (match($0, /^[a-z-]+: /)) {
        field = substr($0, 1, RLENGTH - 2)
        value[field] = substr($0, RLENGTH + 1) "\n"
    } else if (field && $0 ~ /^ /) {
        sub(/^ +/, "")
        value[field] = value[field] $0 "\n"
    }
    next
}
{ program = program $0 "\n" }

END {
    if (list != "") exit 0
    if (get != "") { printf "%s", value[get]; exit 0 }
    if (!n) { print "variant: no entry " name " in " ARGV[1] > "/dev/stderr"; exit 2 }
    for (k = 1; k <= n; k++) {
        at = index(program, text[k, "from"])
        rest = substr(program, at + length(text[k, "from"]))
        if (!at || index(rest, text[k, "from"])) {
            print "variant: " name ": its text number " k " occurs " (at ? "more than once" : "nowhere") " in the solution" > "/dev/stderr"
            exit 2
        }
        program = substr(program, 1, at - 1) text[k, "to"] rest
    }
    printf "%s", program
}
