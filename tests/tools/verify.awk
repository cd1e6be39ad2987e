# verify.awk - is a known mistake, or an equivalent program, judged as it should
# be?
#
#     awk -v kind=mistake -v name=NAME -v nn=07 -f tests/tools/verify.awk \
#         tests/mistakes/NN_slug.txt VARIANT.c solutions/NN_slug.c VERDICT
#
# prints lines "ok WHAT" and "FAIL WHAT: why"; VERDICT is a file with what the
# judge has said.

FNR == 1 { file++ }
# the fields of the entry; what stands between from: and end is a program's
file == 1 && /^(mistake|equivalent): / {
    mine = $2 == name
    field = ""
}
file == 1 && /^from:$/ { program = 1 }
file == 1 && /^end$/ { program = 0 }
file == 1 {
    if (program || !mine) next
    if (match($0, /^[a-z-]+: /)) {
        field = substr($0, 1, RLENGTH - 2)
        sub(/^[a-z-]+: /, "")
    } else if (!/^ /) next
    value[field] = value[field] $0 " "
    next
}
# the slot of the first line which differs
file == 2 { line[FNR] = $0; next }
file == 3 {
    if (differs) next
    if (/\/\* SLOT /) { slot = $3; sub(/\(.*/, "", slot) }
    if ($0 != line[FNR]) differs = 1
    else if (/\/\* END /) slot = ""
    next
}
{
    said = said (FNR > 1 ? "\n" : "") $0
    last = $0
    lines = FNR
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

END {
    if (kind == "equivalent") {
        result(judged("OK"), "equivalent program " name " is OK")
    } else {
        n = split(value["caught-by"] value["also-by"], check, " ")
        for (k = 1; k <= n; k++)
            result(check[k] in failed, name " is caught by " check[k])
        verdict = "WRONG"
        if (split(value["verdict"], word, " ")) verdict = word[1]
        result(judged(verdict), name " gives the verdict " verdict)
        if (value["shows"] != "no ") # else no table has room for it
            result(named, name " is explained")
        else if (known)
            result(named, name " is not taken for another mistake")
        if (split(value["slot"], word, " ")) slot = word[1]
        if (slot != "" && in_slot != "")
            result(slot == in_slot, "the verdict on " name " names slot " slot)
    }
    result(lines <= 24, "the verdict on " name " fits on one screen")
}
