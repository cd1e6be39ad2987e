# json.awk - strings and numbers of JSON, for verdict.awk and gradescope.awk,
# which read the judge's reports (write_report() in tests/checks/judging.h).

BEGIN {
    RS = "\036"
    FS = "\037"
    for (k = 1; k < 256; k++) code[sprintf("%c", k)] = k
}

# How many bytes from the k-th on are one character of UTF-8, or 0.
function character(s, k,   o, more, low, high, i) {
    o = code[substr(s, k, 1)]
    if (o < 128) return 1
    more = o < 194 || o > 244 ? 0 : o < 224 ? 1 : o < 240 ? 2 : 3
    low = o == 224 ? 160 : o == 240 ? 144 : 128
    high = o == 237 ? 159 : o == 244 ? 143 : 191
    for (i = 1; i <= more; i++) {
        o = code[substr(s, k + i, 1)]
        if (o < low || o > high) return 0
        low = 128
        high = 191
    }
    return more ? more + 1 : 0
}

# Quotes, backslashes and control characters are escaped, and what is no UTF-8 is
# replaced.
function string(s,   k, n, c, out) {
    for (k = 1; k <= length(s); k += n ? n : 1) {
        n = character(s, k)
        c = substr(s, k, n)
        if (!n) c = "\\ufffd"
        else if (c == "\"" || c == "\\") c = "\\" c
        else if (c == "\n") c = "\\n"
        else if (code[c] && (code[c] < 32 || code[c] == 127))
            c = sprintf("\\u%04x", code[c])
        out = out c
    }
    return "\"" out "\""
}

function string_or_null(s) { return s == "" ? "null" : string(s) }

# A number where it is one; JSON has no nan and no inf, which stay words.
function value(s) {
    if (s ~ /^-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?$/) return s
    return string_or_null(s)
}

function contents(file,   text) {
    text = ""
    getline text <file
    close(file)
    return text
}
