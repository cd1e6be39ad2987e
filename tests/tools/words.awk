# words.awk - how many words a chapter shows.
#
#     awk -f tests/tools/words.awk lessons/*.md
#
# prints "WORDS FILE", without the worked example, or with -v part=Example the
# words of that alone; with -v most=1200 only the files that show more.  A word
# has a letter or a digit in it, and a formula between dollars is one word.  Not
# counted: tables, fences (code and displayed formulas), what is folded (but for
# what was measured, which is text), comments, link definitions, where a link
# leads, the text in place of a picture, the number of a heading, and what is the
# same in all chapters (fold.awk).

function report() { if (file != "" && words > most) print words, file }

BEGIN { if (most == "") most = -1 }
FNR == 1 {
    report()
    file = FILENAME
    words = fence = folded = comment = 0
    within = ""
}
/^## / { within = $2 }
part != "" && within != part || part == "" && within == "Example" { next }
/^ *```/ { fence = !fence; next }
fence { next }
/^<details><summary>Measured/ || /^Read as far as this list/ { next }
/^ *<details/ { folded = 1 }
/<\/details>/ { folded = 0; next }
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
    gsub(/\$+[^$]+\$+/, "x", line)
    gsub(/!\[[^]]*\]\([^)]*\)/, " ", line)
    gsub(/\]\([^)]*\)/, " ", line)
    sub(/^#+ *(Lesson )?[0-9]*[:.]?/, "", line)
    n = split(line, word, " ")
    for (i = 1; i <= n; i++) words += word[i] ~ /[A-Za-z0-9]/
}
END { report() }
