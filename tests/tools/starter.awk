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
# In the starter the code becomes todo("7a", x, u); the names in parentheses
# are what the slot has to work with.  Lines with SOLUTION: in the header
# comment become their LESSON: twin, so that the file says what it is.

/\/\* SLOT [0-9]+[a-z]\(/ {
    indent = $0; sub(/\/\*.*/, "", indent)
    slot = $0; sub(/.*\/\* SLOT /, "", slot)
    arguments = slot
    sub(/\(.*/, "", slot)
    sub(/^[^(]*\(/, "", arguments)
    if (arguments !~ /\)/) { print "starter: slot " slot ": the names must close on its first line" > "/dev/stderr"; exit 2 }
    sub(/\).*/, "", arguments)
    in_comment = 1
    cutting = 1
}
cutting && $0 ~ "/\\* END " slot " \\*/" {
    print indent "todo(\"" slot "\"" (arguments == "" ? "" : ", " arguments) ");"
    cutting = 0
}
!cutting || in_comment { print }
in_comment && /\*\// { in_comment = 0 }
END { if (cutting) { print "starter: slot " slot " has no END" > "/dev/stderr"; exit 2 } }
