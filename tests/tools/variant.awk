# variant.awk - known mistakes and equivalent programs, as replacements.
#
#     awk -f tests/tools/variant.awk -v list=mistake FILE           their names
#     awk -f tests/tools/variant.awk -v name=X -v get=why FILE      one field,
#                                                                   or a,b two
#     awk -f tests/tools/variant.awk -v name=X FILE SOLUTION        the program
#     awk -f tests/tools/variant.awk -v all=DIR FILE SOLUTION       DIR/all.c is all
#         of them: which, the number MISTAKE in the environment says, and with none
#         it is the solution.  DIR/NAME and NAME.judge run one of its judge all.judge,
#         NAME.why has what is said of a mistake.  The numbers, what each is, its
#         name, and the slot of the first line changed are printed; - for none, and
#         "alone" for the number of one that changes what is in no function.
#         With file=F it is those of the file F alone, and DIR has all.c alone.
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
# Several from/to pairs in an entry are applied one after another.  Those of a
# lesson change functions, between the { and the } that begin a line, alone.
# Entries of tests/unit/mistakes.txt stand below the file that they change, a
# line "file: common/bar/bar.c", and are caught-by: UNIT-PROGRAM: LAW.

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
    value[n, "file"] = of
    next
}
FILENAME == ARGV[1] && !open && /^file: / { of = $2 "\n"; next }
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
function changed(e, program,    k, at, rest, from) {
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
# Its functions, from { to }, go to body[1], body[2], ...; what is left is returned,
# with \001 where they stood.
function bodies(text, body,    n, line, lines, k, inside, rest) {
    lines = split(text, line, "\n")
    for (k = 1; k < lines; k++) {
        if (!inside && line[k] == "{") {
            inside = 1
            body[++n] = ""
            rest = rest "\001"
        }
        if (inside) body[n] = body[n] line[k] "\n"
        else rest = rest line[k] "\n"
        if (line[k] == "}") inside = 0
    }
    return rest
}
# The slot of the first line in which two programs differ, or -.
function slot_of(program, text,    line, lines, other, k, part, slot) {
    lines = split(program, line, "\n")
    split(text, other, "\n")
    for (k = 1; k <= lines; k++) {
        if (line[k] ~ /\/\* SLOT /) {
            split(line[k], part, " ")
            slot = part[3]
            sub(/\(.*/, "", slot)
        }
        if (line[k] != other[k]) break
        if (line[k] ~ /\/\* END /) slot = ""
    }
    return slot == "" ? "-" : slot
}
function put(e, its,    run) {
    run = "#!/bin/sh\nMISTAKE=" e " exec \"${0%/*}/all.judge\" "
    print run "--run \"$@\"" > its
    close(its)
    print run "\"$@\"" > (its ".judge")
    close(its ".judge")
    if (kind[e] == "equivalent") return
    printf "%s%s", value[e, "caught-by"], value[e, "why"] > (its ".why")
    close(its ".why")
}
# All entries in one program: a function with a mistake has a case for each.
function merge(    e, m, rest, text, own, its, part, parts, at, number) {
    rest = bodies(program, own)
    parts = split(rest, part, "\001")
    for (e = 1; e <= n; e++) {
        if (file != "" && value[e, "file"] != file "\n") continue
        text = changed(e, program)
        number = e
        if (bodies(text, its) != rest) number = "alone"
        if (e in problem) number = "-"
        at = file == "" ? slot_of(program, text) : value[e, "caught-by"]
        gsub(/:? |\n/, " ", at)
        print number, kind[e], title[e], at
        if (number != e) continue
        if (file == "") put(e, all "/" title[e])
        for (m = 1; m < parts; m++)
            if (its[m] != own[m])
                cases[m] = cases[m] "case " e ":\n" its[m] "break;\n"
    }
    all = all "/all.c"
    printf "%s", "extern char *getenv(const char *);\n" \
        "extern int atoi(const char *);\n" \
        "static int mistake_number(void)\n{\n    static int is = -1;\n" \
        "    if (is < 0) is = getenv(\"MISTAKE\") ? atoi(getenv(\"MISTAKE\")) : 0;\n" \
        "    return is;\n}\n" > all
    for (m = 1; m <= parts; m++) {
        printf "%s", part[m] > all
        if (m in cases)
            printf "{\nswitch (mistake_number()) {\n%sdefault:\n%s}\n}\n", \
                cases[m], own[m] > all
        else if (m < parts) printf "%s", own[m] > all
    }
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
    if (all != "") {
        merge()
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
