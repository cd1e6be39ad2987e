# slots.awk - does a solution begin with its slots, and explain what is in them?
#
#     awk -v rule=RULE -f tests/tools/slots.awk solutions/*.c
#
# prints the solutions that break a rule:
#   first     the first slot begins before line 70
#   order     slots stand in the order of their letters
#   declared  no function with a slot is declared before it is defined, which
#             would let pages of output stand before it
#   comments  one comment for every 15 lines inside the slots, where these are more

function judge(    name) {
    if (file == "") return
    if (rule == "first" && first >= 70) print file ": line " first
    if (rule == "order" && disorder != "") print file ":" disorder
    if (rule == "comments" && lines > 15 && 15 * comments < lines)
        print file ": " comments + 0 " for " lines " lines"
    if (rule == "declared")
        for (name in declared) if (name in taught) print file ": " name
}

FNR == 1 {
    judge()
    file = FILENAME
    first = lines = comments = inside = in_head = naming = 0
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
    inside = in_head = 1
}
/\/\* END [0-9]+[a-z] \*\// { inside = 0 }
inside && !in_head { lines++; comments += gsub(/\/\*/, "/*") }
in_head && /\*\// { in_head = 0 }
END { judge() }
