# debug.awk - the first report of a sanitizer, for the eye.
#
#     awk -f tests/tools/debug.awk -v mine=lessons/NN_slug.c FILE
#
# FILE is the stderr of a program.  What the program itself wrote there comes
# first, as it is; then what was found, and the lines of the workbook that led
# there, with the text of the first one in `mine`.  Status 1: something was found.
function place(text) { # the workbook's file and line in a frame, or ""
    if (!match(text, /(lessons|common|solutions)\/[A-Za-z0-9_\/.-]+:[0-9]+/))
        return ""
    return substr(text, RSTART, RLENGTH)
}
function show(words, at,   k, line) {
    print "    " words ", " at
    if (told || index(at, mine ":") != 1) return
    told = 1
    for (k = substr(at, length(mine) + 2) + 0; k > 0; k--) getline line <mine
    sub(/^ +/, "", line)
    print "        " line
}
!found && /ERROR: [A-Za-z]+Sanitizer: |: runtime error: / {
    found = 1
    stack = "here"
    at = /: runtime error: / ? place($0) : ""
    sub(/^.*(Sanitizer|runtime error): /, "")
    sub(/ \(pc .*/, "")
    sub(/ on address 0x.*/, "")
    print "  found: " $0
    next
}
!found && (/^=+$/ || /Sanitizer:DEADLYSIGNAL/) { next }
!found {
    if (++own <= 40) print
    if (own == 41) print "  ..."
    next
}
/^(READ|WRITE) of size/ { print "    a " tolower($1) " of " $4 " bytes" }
/ is located .* region/ {
    sub(/^.*is located/, "    it is")
    sub(/ \[0x.*/, "")
    print
}
/^freed by thread/ { stack = "freed" }
/^(previously )?allocated by thread/ { stack = "allocated" }
/^ *#[0-9]+ / && stack != "" && place($0) != "" {
    name = $0
    sub(/^.* in /, "", name)
    sub(/[ (].*/, "", name)
    if (stack == "here") {
        if (++frames <= 5) show((frames > 1 ? "called by " : "in ") name, place($0))
    } else if (name != "allocate") { # of base/status.h
        show(stack " by " name, place($0))
        stack = ""
    }
}
/^SUMMARY/ { exit }
END {
    if (found && !frames && at != "") show("in", at)
    else if (found && !frames) print "    (gdb says where: `backtrace`)"
    exit found
}
