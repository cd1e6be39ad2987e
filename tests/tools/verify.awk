# verify.awk - are known mistakes and equivalent programs judged as they should
# be?
#
#     awk -v nn=07 -f tests/tools/verify.awk tests/mistakes/NN_slug.txt SAID
#
# prints lines "ok WHAT" and "FAIL WHAT: why".  SAID has for each of them a line
# "entry NUMBER KIND NAME SLOT", as variant.awk gives it, and what the judge has said.

FNR == 1 { file++ }
# the fields of the entries; what stands between from: and end is a program's
file == 1 && /^(mistake|equivalent): / { of = $2 }
file == 1 && /^from:$/ { program = 1 }
file == 1 && /^end$/ { program = 0 }
file == 1 {
    if (program) next
    if (match($0, /^[a-z-]+: /)) {
        field = substr($0, 1, RLENGTH - 2)
        sub(/^[a-z-]+: /, "")
    } else if (!/^ /) next
    value[of, field] = value[of, field] $0 " "
    next
}
/^entry / {
    if (name) verify()
    number = $2; kind = $3; name = $4; slot = $5
    said = last = in_slot = ""
    lines = known = named = 0
    split("", failed)
    next
}
{
    said = said (lines++ ? "\n" : "") $0
    last = $0
    if (/^  [A-Z]+ +[a-z_0-9A-Z]+$/) failed[$2]
    if (/known mistake/) known = 1
    if (/^ / && index($0, "(" name ")")) named = 1
    if (/^  In .* \(slot .*\):$/ && in_slot == "") {
        in_slot = $0
        sub(/.* \(slot /, "", in_slot)
        sub(/\):$/, "", in_slot)
    }
}

function result(holds, what) {
    if (holds) print "ok " nn ": " what
    else print "FAIL " nn ": " what ": " said
}
function judged(verdict) { return index(last, "VERDICT " nn ": " verdict) == 1 }

function verify(    n, k, check, word, verdict) {
    if (number !~ /^[0-9]/) {
        result(0, name (number == "-" ? \
            " does not fit the solution: make lint says where" : \
            " changes what is in no function"))
        return
    }
    if (kind == "equivalent") {
        result(judged("OK"), "equivalent program " name " is OK")
    } else {
        n = split(value[name, "caught-by"] value[name, "also-by"], check, " ")
        for (k = 1; k <= n; k++)
            result(check[k] in failed, name " is caught by " check[k])
        verdict = "WRONG"
        if (split(value[name, "verdict"], word, " ")) verdict = word[1]
        result(judged(verdict), name " gives the verdict " verdict)
        if (value[name, "shows"] != "no ") # else no table has room for it
            result(named, name " is explained")
        else if (known)
            result(named, name " is not taken for another mistake")
        if (split(value[name, "slot"], word, " ")) slot = word[1]
        if (slot != "-" && in_slot != "")
            result(slot == in_slot, "the verdict on " name " names slot " slot)
    }
    result(lines <= 24, "the verdict on " name " fits on one screen")
}
END { if (name) verify() }
