# schema.awk - is a file JSON, and does it keep to a schema?
#
#     awk -f schema.awk SCHEMA FILE
#
# prints what is wrong, the first of it, and ends with status 1.  Of JSON Schema
# it knows type, enum, required, properties, additionalProperties and items.

function fail(what) {
    print FILENAME ": " what
    status = 1
    exit 1
}
function skip() { sub(/^[ \t\r\n]+/, "", text) }
function take(c) {
    skip()
    if (substr(text, 1, 1) != c)
        fail("`" c "` is due before: " substr(text, 1, 40))
    text = substr(text, 2)
}
function next_is(c) {
    skip()
    return substr(text, 1, 1) == c
}
# The strings are kept as they are spelt.
function take_string(   s) {
    skip()
    if (!match(text, /^"([^"\\\001-\037]|\\["\\\/bfnrt]|\\u[0-9a-fA-F][0-9a-fA-F][0-9a-fA-F][0-9a-fA-F])*"/))
        fail("no string: " substr(text, 1, 40))
    s = substr(text, 2, RLENGTH - 2)
    text = substr(text, RLENGTH + 1)
    return s
}
# A value of the tree: its kind, and value or keys, by its path.
function take_value(at,   n, key) {
    skip()
    size[at] = 0
    if (next_is("{")) {
        kind[at] = "object"
        take("{")
        if (!next_is("}")) do {
            if (n++) take(",")
            key = take_string()
            if ((at "/" key) in kind) fail("twice: " key)
            take(":")
            take_value(at "/" key)
            keys[at, n] = key
        } while (next_is(","))
        take("}")
    } else if (next_is("[")) {
        kind[at] = "array"
        take("[")
        if (!next_is("]")) do {
            if (n++) take(",")
            take_value(at "/" n)
        } while (next_is(","))
        take("]")
    } else if (next_is("\"")) {
        kind[at] = "string"
        leaf[at] = take_string()
    } else if (match(text, /^(true|false|null|-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?)/)) {
        leaf[at] = substr(text, 1, RLENGTH)
        kind[at] = leaf[at] == "null" ? "null" : \
                   leaf[at] ~ /^[tf]/ ? "boolean" : "number"
        text = substr(text, RLENGTH + 1)
    } else
        fail("no value: " substr(text, 1, 40))
    size[at] = n + 0
}
# Whether `word` is the leaf LIST, or one of those in it.
function listed(word, list,   k) {
    for (k = 1; k <= size[list]; k++) if (leaf[list "/" k] == word) return 1
    return kind[list] == "string" && leaf[list] == word
}
function keeps(at, rule,   k, key) {
    if ((rule "/type") in kind && !listed(kind[at], rule "/type"))
        fail(at " is of type " kind[at])
    if ((rule "/enum") in kind && !listed(leaf[at], rule "/enum"))
        fail(at " is " leaf[at])
    for (k = 1; k <= size[rule "/required"]; k++) {
        key = leaf[rule "/required/" k]
        if (!((at "/" key) in kind)) fail(at " has no " key)
    }
    for (k = 1; kind[at] == "object" && k <= size[at]; k++) {
        key = keys[at, k]
        if ((rule "/properties/" key) in kind)
            keeps(at "/" key, rule "/properties/" key)
        else if (leaf[rule "/additionalProperties"] == "false")
            fail(at " has a key " key)
    }
    if ((rule "/items") in kind)
        for (k = 1; k <= size[at]; k++) keeps(at "/" k, rule "/items")
}
function end_file() {
    take_value(name)
    skip()
    if (text != "") fail("more than one value: " substr(text, 1, 40))
    text = ""
}
FNR == 1 && NR > 1 { end_file() }
FNR == 1 { name = NR == 1 ? "schema" : "file" }
{ text = text $0 "\n" }
END {
    if (status) exit status
    if (name != "file") fail("the file is empty")
    end_file()
    keeps("file", "schema")
}
