# minutes.awk - how long a chapter takes, by the rule that TEACHING.md states.
#
#     awk -v words=N -f tests/tools/minutes.awk CHAPTER [SOLUTION.c]
#
# N are the words that it shows (words.awk).  A minute for each sixty words, which
# is slow, since there are formulas, tables and pictures between them; for an
# exercise On paper 5 minutes as a warm-up, 10 as core (or without a mark), 20 if
# it is hard; 3 for each question of Predict; and one for each line of the slots as
# the solution has them, without comments, blank lines and lone braces.  The sum is
# rounded to 5 minutes.

FNR == 1 { file++; section = ""; slot = 0 }
file == 1 && /^## / { section = substr($0, 4) }
file == 1 && /^[0-9]+\. / {
    if (section == "On paper")
        paper += /^[0-9]+\. \*Warm-up\.\*/ ? 5 : /^[0-9]+\. \*Hard\.\*/ ? 20 : 10
    if (section == "Predict") questions++
}
file == 1 && section == "Predict" { marks += gsub(/\?/, "?") }
file == 2 && /\/\* END [0-9]+[a-z] \*\// { slot = 0 }
file == 2 && slot {
    line = $0
    if (comment && !sub(/^.*\*\//, "", line)) next
    comment = 0
    gsub(/\/\*[^*]*\*\//, "", line)
    if (sub(/\/\*.*/, "", line)) comment = 1
    lines += line ~ /[^ {}]/
}
file == 2 && /\/\* SLOT / { slot = 1; comment = !/\*\// }
END {
    if (!questions) questions = marks
    sum = words / 60 + paper + 3 * questions + lines
    if (parts) print words / 60, paper, 3 * questions, lines + 0
    print 5 * int(sum / 5 + 0.5)
}
