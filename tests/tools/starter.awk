# starter.awk - derive a lesson's starter from its solution.
#
#     awk -f tests/tools/starter.awk solutions/NN_slug.c > lessons/NN_slug.c
#
# A slot in the solution is
#
#     /* SLOT 7a(x, u): what to write, with its equation label [eq:slug].
#      * More lines as needed. */
#     ...the code that the student writes...
#     /* END 7a */
#
# In the starter the code becomes todo("7a", x, u); the names in parentheses,
# which may go on in the next lines, are what the slot has to work with.  Lines with SOLUTION: in the header
# comment become their LESSON: twin, so that the file says what it is.

/\/\* SLOT [0-9]+[a-z]\(/ {
    indent = $0; sub(/\/\*.*/, "", indent)
    slot = $0; sub(/.*\/\* SLOT /, "", slot)
    arguments = slot
    sub(/\(.*/, "", slot)
    sub(/^[^(]*\(/, "", arguments)
    naming = in_comment = cutting = 1
}
naming {
    if ($0 !~ /\/\* SLOT /) {
        more = $0; sub(/^ *\* */, "", more)
        arguments = arguments " " more
    }
    if (arguments ~ /\)/) {
        sub(/\).*/, "", arguments)
        naming = 0
    } else if (/\*\//) {
        print "starter: the names of slot " slot " do not end" > "/dev/stderr"
        exit 2
    }
}
cutting && $0 ~ "/\\* END " slot " \\*/" {
    n = split(arguments, name, /, */)
    line = indent "todo(\"" slot "\""
    for (k = 1; k <= n; k++) {
        line = line ","
        if (length(line " " name[k]) > 77) {
            print line
            line = indent "     "
        }
        line = line (line ~ / $/ ? "" : " ") name[k]
    }
    print line ");"
    cutting = 0
}
!cutting || in_comment { print }
in_comment && /\*\// { in_comment = 0 }
END { if (cutting) { print "starter: slot " slot " has no END" > "/dev/stderr"; exit 2 } }
