# hand.awk - a student's file in which what is not written yet is the solution's.
#
#     awk [-v whose=FILE] -f tests/tools/hand.awk solutions/NN_slug.c lessons/NN_slug.c
#
# In the file `whose` stands which slots are whose: "yours: 12a 12b; reference: 12c".

FNR == 1 { part++; slot = ""; sub(/^\357\273\277/, "") }
{ sub(/\r+$/, "") }
match($0, /\/\* SLOT [0-9]+[a-z]\(/) {
    slot = substr($0, RSTART + 8, RLENGTH - 9)
    contract = 1
    body = ""
}
slot == "" { if (part == 2) print; next }
contract { # up to the end of its comment
    if (part == 2) print
    if (/\*\//) contract = 0
    next
}
$0 ~ "/\\* END " slot " \\*/" {
    if (part == 1) text[slot] = body
    else {
        unwritten = index(body, "todo(\"" slot "\"") && slot in text
        printf "%s", unwritten ? text[slot] : body
        if (unwritten) theirs = theirs " " slot
        else yours = yours " " slot
        print
    }
    slot = ""
    next
}
{ body = body $0 "\n" }
END {
    if (part == 2 && slot != "") printf "%s", body # it has no end
    print "yours:" (yours == "" ? " none" : yours) \
        (theirs == "" ? "" : "; reference:" theirs) > whose
}
