# slots.awk - does a solution begin with its slots?
#
#     awk -v rule=RULE -f tests/tools/slots.awk solutions/*.c
#
# prints the solutions that break a rule:
#   first     the first slot begins before line 70
#   order     slots stand in the order of their letters
#   declared  no function with a slot is declared before it is defined, which
#             would let pages of output stand before it

function judge(    name) {
    if (file == "") return
    if (rule == "first" && first >= 70) print file ": line " first
    if (rule == "order" && disorder != "") print file ":" disorder
    if (rule == "declared")
        for (name in declared) if (name in taught) print file ": " name
}

FNR == 1 {
    judge()
    file = FILENAME
    first = naming = 0
    disorder = before = current = ""
    split("", declared)
    split("", taught)
}

# a function's head, which may take several lines: static T name(...) { or ;
/^static [^=]*$/ && !/^static [^(]*[{;]/ { naming = 1; head = "" }
naming {
    head = head $0
    if (head ~ /[{;]/ || /^}/) {
        naming = 0
        name = head
        sub(/\(.*/, "", name)
        sub(/.*[ *]/, "", name)
        if (head ~ /;/ && head !~ /\{/) declared[name] = 1
        else current = name
    }
}

/\/\* SLOT [0-9]+[a-z]\(/ {
    slot = $0
    sub(/.*\/\* SLOT [0-9]+/, "", slot)
    slot = substr(slot, 1, 1)
    if (!first) first = FNR
    if (slot < before) disorder = disorder " " before " before " slot
    before = slot
    taught[current] = 1
}
END { judge() }
