# math.awk - formulas that some renderer of Markdown would change.
#
#     awk -f tests/tools/math.awk lessons/*.md
#
# prints "FILE:LINE: FORMULA".  Markdown takes \, and \{ for escapes, and * and
# a _ after a bracket for emphasis; GitHub does not know \operatorname.  So
# between dollars every backslash stands before a letter, every _ after a letter
# or a digit, and there is no *; a blank does for \,.  A formula stands on one
# line; matrices and longer ones go into a fence, ```math, which Markdown leaves
# alone.

function judge(formula) {
    if (formula ~ /\\([^A-Za-z]|$)/ || formula ~ /operatorname|[*]/ ||
        formula ~ /(^|[^A-Za-z0-9])_/)
        print FILENAME ":" FNR ": " formula
}

FNR == 1 { fence = "" }
/^ *```/ {
    fence = fence == "" ? $1 : ""
    next
}
fence != "" {
    if (fence == "```math" && /operatorname/) print FILENAME ":" FNR ": " $0
    next
}
{
    line = $0
    while (match(line, /[`$]+/)) {
        mark = substr(line, RSTART, RLENGTH)
        # a run may be mixed, as in $`a`$: only its first kind counts
        if (mark ~ /^`/) sub(/[$].*/, "", mark); else sub(/`.*/, "", mark)
        line = substr(line, RSTART + length(mark))
        end = index(line, mark)
        if (!end) {
            if (mark ~ /[$]/) print FILENAME ":" FNR ": no second " mark
            next
        }
        if (mark ~ /[$]/) judge(substr(line, 1, end - 1))
        line = substr(line, end + length(mark))
    }
}
