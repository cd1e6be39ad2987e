# words.awk - how many words a chapter shows, or how many of its sentences are
# short.
#
#     awk -f tests/tools/words.awk lessons/*.md
#     awk -v part=Theory,Example -v most=600 -f ...
#     awk -v part=rest -v most=1100 -f ...
#     awk -v short=8 -v most=15 -f ...
#
# prints "WORDS FILE"; with `part` the words of sections whose names begin so, or
# of all but Theory and Example; with `most` only the files that show more.  A
# word has a letter or a digit in it, and a formula between dollars is one word.
# Not counted: tables, fences (code and displayed formulas), what is folded (but
# for what was measured, which is text), comments, link definitions, where a link
# leads, the text in place of a picture, the number of a heading, and what is the
# same in all chapters (fold.awk).
#
# With `short` it prints "SHARE % FILE: SHORT of SENTENCES", the share of
# sentences of at most so many words.  A sentence ends in . ! or ? before a
# capital, a digit, a formula or the like; across a displayed formula it goes on.  A
# formula with a relation, like $a=b$, is read as four words here.
# Not counted: the head of a chapter, headings, the number of a picture, words in
# italics with a stop, as the mark of an exercise, bold words that a paragraph
# begins with, what ends in a colon, as in front of a table, or without a stop, and
# what all chapters say (Open ..., Draw yours ...).

function report() {
    if (file == "") return
    sentences_of(text)
    if (short == "") {
        if (words > most) print words, file
    } else if (all && 100 * few / all > most)
        printf "%.1f %% %s: %d of %d\n", 100 * few / all, file, few, all
}
# The sentences of a text are counted in few and all, and shown with -v list=1.
function sentences_of(rest,    one, n, i, k, word) {
    text = ""
    if (short == "") return
    while (match(rest, /[.!?][])"'*_]* +[^a-z ]|[.!?][])"'*_]* *$/)) {
        one = one substr(rest, 1, RSTART)
        rest = substr(rest, RSTART + 1)
        if (one ~ /(^|[ (])([A-Z]|e\.g|i\.e|cf|vs|p|pp|sec)\.$/) continue
        n = split(one, word, " ")
        for (i = k = 0; n; n--) k += word[n] ~ /[A-Za-z0-9]/
        if (one ~ /TODO/) k = 0 # it is not written yet
        if (k) all++
        if (k && k <= short) few++
        if (k && k <= short && list) print file ": " one
        one = ""
    }
}

# Formulas with a relation as the words that they are read with.
function spoken(line,    done, one) {
    while (match(line, /\$+[^$]+\$+/)) {
        one = substr(line, RSTART, RLENGTH)
        done = done substr(line, 1, RSTART - 1) \
            (one ~ /[=<>]|\\(l[et]|g[et]|ne|to|in|approx|sim|leftarrow)([^a-z]|$)/ ? said : "Xx")
        line = substr(line, RSTART + RLENGTH)
    }
    return done line
}

BEGIN { if (most == "") most = -1; said = "Xx is so much" }
FNR == 1 {
    report()
    file = FILENAME
    words = fence = folded = comment = few = all = 0
    within = text = ""
}
/^## / { within = $2; sentences_of(text) }
part == "rest" && within ~ /^(Theory|Example)$/ { next }
part != "" && part != "rest" && index("," part ",", "," within ",") == 0 { next }
/^ *```/ { fence = !fence; if (fence && /```math/) text = text said; next }
fence { next }
/^<details><summary>Measured/ || /^Read as far as this list/ || /^Open `lessons.*make check/ { next }
/^ *<details/ { folded = 1 }
/<\/details>/ { folded = 0; next }
/^ *\|/ { sentences_of(text) }
folded || /^ *\|/ || /^ *\[[^]]*\]: / { next }
{
    line = $0
    if (comment && !sub(/^.*-->/, "", line)) next
    comment = 0
    while (match(line, /<!--/)) { # to the first end behind it
        rest = substr(line, RSTART)
        line = substr(line, 1, RSTART - 1)
        end = index(rest, "-->")
        comment = !end
        if (end) line = line substr(rest, end + 3)
    }
    gsub(/<[^>]*>/, " ", line)
    if (short != "") line = spoken(line)
    gsub(/\$+[^$]+\$+/, "Xx", line)
    gsub(/!\[[^]]*\]\([^)]*\)/, " ", line)
    gsub(/\]\([^)]*\)/, "]", line)
    sub(/^#+ *(Lesson )?[0-9]*[:.]?/, "", line)
    n = split(line, word, " ")
    for (i = 1; i <= n; i++) words += word[i] ~ /[A-Za-z0-9]/
    if (short == "" || within == "" || /^#/ || /^(Previous: |Hints and |Draw yours|Open )/) next
    if (sub(/^ *([0-9]+\.|[-*]) /, "", line) || /^(\*Figure|\*\*)/) sentences_of(text)
    sub(/^\*Figure [0-9A-Z]+\.[0-9]+\. /, "", line)
    sub(/^ *\*\*([^*]*[.?:]\*\*|[^*]*\*\*( \([^()]*\))?\.) */, "", line)
    gsub(/\*[A-Z][^*]*\.\*/, "", line)
    sub(/^ *\([^()]*\) /, "", line)
    text = text " " line
}
END { report() }
