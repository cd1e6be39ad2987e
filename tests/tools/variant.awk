# variant.awk - known mistakes and equivalent programs, as replacements.
#
#     awk -f tests/tools/variant.awk -v list=mistake FILE           their names
#     awk -f tests/tools/variant.awk -v name=X -v get=why FILE      one field,
#                                                                   or a,b two
#     awk -f tests/tools/variant.awk -v name=X FILE SOLUTION        the program
#     awk -f tests/tools/variant.awk -v check=SOLUTION FILE         what is wrong
#         with the entries, a line each; with a folder, "common/", the program is
#         that folder and what the entry's `file:` says
#
# FILE is tests/mistakes/NN_slug.txt, entries of the form
#
#     mistake: lift_forgotten          (or  equivalent: another_way)
#     caught-by: name_of_the_check     (mistakes only; the first that fails,
#                                       or the mistake is never named)
#     also-by: another_check           (which fails as well)
#     verdict: NONFINITE               (where it is not WRONG)
#     slot: 9c                         (where the verdict may name another slot
#                                       than that of the first line changed)
#     shows: no                        (where no run that ends well shows it, nor
#                                       what the check `got`: it is caught, but
#                                       cannot be explained)
#     reading: 3a WORDS                (equivalents only: one reading of the
#                                       words WORDS of that slot's contract,
#                                       which leave a choice)
#     why: what the student is told, two lines or so;
#       a continuation is indented.
#     from:
#     ...lines of the solution, to the letter; they must occur exactly once...
#     to:
#     ...what stands there instead...
#     end
#
# Several from/to pairs in an entry are applied one after another.

function wrong(e, what) { if (!(e in problem)) problem[e] = what }

FILENAME == ARGV[1] && match($0, /^(mistake|equivalent): /) {
    # no program has such a line in it
    if (open) wrong(n, "has no `end`")
    kind[++n] = substr($0, 1, RLENGTH - 2)
    title[n] = substr($0, RLENGTH + 1)
    if (title[n] in entry) {
        wrong(n, "is there twice")
        wrong(entry[title[n]], "is there twice")
    }
    entry[title[n]] = n
    open = 1
    part = field = ""
    next
}
FILENAME == ARGV[1] {
    if ($0 == "from:") {
        if (!open && n) wrong(n, "is followed by lines of no entry")
        part = "from"
        pairs[n]++
    } else if ($0 == "to:") {
        part = "to"
    } else if ($0 == "end") {
        part = field = ""
        open = 0
    } else if (part) {
        text[n, pairs[n], part] = text[n, pairs[n], part] $0 "\n"
    } else if (match($0, /^[a-z-]+: /)) {
        field = substr($0, 1, RLENGTH - 2)
        value[n, field] = substr($0, RLENGTH + 1) "\n"
    } else if (field && $0 ~ /^ /) {
        sub(/^ +/, "")
        value[n, field] = value[n, field] $0 "\n"
    }
    next
}
{ program = program $0 "\n" }

# The program with entry e; where that cannot be, problem[e] says why.
function changed(e, program,   k, at, rest, from) {
    if (!pairs[e]) wrong(e, "changes nothing")
    for (k = 1; k <= pairs[e] && !(e in problem); k++) {
        from = text[e, k, "from"]
        at = from == "" ? 0 : index(program, from)
        rest = substr(program, at + length(from))
        if (!at) wrong(e, "its text number " k " is nowhere in the program")
        else if (index(rest, from))
            wrong(e, "its text number " k " is there more than once")
        else if (from == text[e, k, "to"])
            wrong(e, "its text number " k " changes nothing")
        program = substr(program, 1, at - 1) text[e, k, "to"] rest
    }
    return program
}
# The text of a file, read once.
function read(file,   line) {
    if (!(file in whole)) {
        whole[file] = ""
        while ((getline line < file) > 0) whole[file] = whole[file] line "\n"
        close(file)
    }
    return whole[file]
}

END {
    if (open) wrong(n, "has no `end`")
    if (list != "") {
        for (e = 1; e <= n; e++) if (kind[e] == list) print title[e]
        exit 0
    }
    if (check != "") {
        for (e = 1; e <= n; e++) {
            file = check
            if (file ~ /\/$/) file = file value[e, "file"]
            gsub(/^\.\/|\n$/, "", file)
            if (read(file) == "") wrong(e, "no file " file)
            if (kind[e] == "mistake" && !((e, "caught-by") in value))
                wrong(e, "has no `caught-by:`")
            changed(e, read(file))
            sub(/in the program$/, "in " file, problem[e])
            said = title[e] ": " problem[e]
            if (problem[e] != "" && !saying[said]++) print said
        }
        exit 0
    }
    e = entry[name]
    if (!e) problem[e] = "is no entry"
    else if (get != "" && !(e in problem)) {
        fields = split(get, field_of, ",")
        for (k = 1; k <= fields; k++) printf "%s", value[e, field_of[k]]
        exit 0
    }
    if (e) program = changed(e, program)
    if (e in problem) {
        print "variant: " ARGV[1] ": " name ": " problem[e] > "/dev/stderr"
        exit 2
    }
    printf "%s", program
}
