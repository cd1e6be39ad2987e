# readings.awk - a contract that leaves a choice, and a program per reading.
#
#     awk -f tests/tools/readings.awk solutions/NN_slug.c \
#         tests/mistakes/NN_slug.txt common/*/*.h
#
# prints a line for each slot whose contract (the comment before its function
# and the SLOT comment) has one of the words below and no `reading: SLOT WORDS`
# in any equivalent program, and for each reading whose words are neither there
# nor in a header.
BEGIN {
    choice = "any of them|in any order|matters?|will do|or not|incomplete|" \
        "meaningless|means nothing|of no use|overwritten"
}
function bare(text) {
    gsub(/^ *\/?\*+|\*\/ *$/, "", text)
    return text
}
FNR == 1 { file++ }
file > 2 { header = header " " bare($0); next }
file == 1 && /^\/\*/ { comment = ""; inside = "comment" }
file == 1 && /\/\* SLOT / {
    slot = $3
    sub(/\(.*/, "", slot)
    inside = slot
    contract[slot] = comment
}
file == 1 && inside != "" {
    if (inside == "comment") comment = comment " " bare($0)
    else contract[inside] = contract[inside] " " bare($0)
    if (/\*\//) inside = ""
    next
}
file == 1 && /^}/ { comment = "" }
file == 2 && /^(mistake|equivalent): / { kind = $1; name = $2 }
file == 2 && /^from:$/ { kind = "" }
file == 2 && kind != "" && /^reading: / {
    if (kind != "equivalent:") print name ": a mistake is no reading"
    said[++n] = name
    of[n] = $2
    words[n] = $0
    sub(/^reading: [^ ]+ */, "", words[n])
}
END {
    gsub(/ +/, " ", header)
    for (slot in contract) gsub(/ +/, " ", contract[slot])
    for (k = 1; k <= n; k++) {
        if (words[k] == "" || !(of[k] in contract) ||
            !index(contract[of[k]] header, words[k]))
            print said[k] ": slot " of[k] " does not say: " words[k]
        read[of[k]] = 1
    }
    for (slot in contract)
        if (tolower(" " contract[slot] " ") ~ ("[^a-z](" choice ")[^a-z]") &&
            !(slot in read))
            print "slot " slot " leaves a choice, and no program has a reading"
}
