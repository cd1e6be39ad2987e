# same.awk - have two runs printed the same tables (common/base/table.h)?
#
#     awk -f tests/tools/same.awk ONE OTHER
#
# Names, comments, headers, words, whole numbers and the number of rows have to be
# equal.  Of two other numbers the difference may be
#
#     1e-9 of the largest number of the column, its scale, so that nine digits of
#          that are the same everywhere;
#     1e-13, for residuals and errors are fractions of 1, and this is round-off;
#     one of the last digit that is printed, in a number like 2.385e+00: its study
#          says that the others are amplified round-off (cell_rounded()).
#
# Prints "TABLE COLUMN row ROW: this, that" for the first cell of each column that
# differs; exit status 1 if there is any.

function say(text) { print text; different = 1 }
function number(text) {
    return text ~ /^-?([0-9]+\.?[0-9]*|\.[0-9]+)(e[-+]?[0-9]+)?$/
}
function size(x) { return x < 0 ? -x : x }
function rounded(text) { return text ~ /^-?[0-9]\.[0-9]+e[-+][0-9]+$/ && \
                                length(text) < 17 }
# what one more in the last digit of a rounded number is
function last_digit(text,    part, point) {
    split(text, part, "e")
    point = index(part[1], ".")
    return 10 ^ (part[2] - (point ? length(part[1]) - point : 0))
}
function same(one, other, c,    x, y, gap) {
    if (one == other) return 1
    if (!number(one) || !number(other)) return 0
    x = one + 0; y = other + 0
    if (one ~ /^-?[0-9]+$/ && other ~ /^-?[0-9]+$/) return x == y
    gap = size(x - y)
    if (rounded(one) && rounded(other) && gap <= 1.01 * last_digit(one)) return 1
    return gap <= 1e-9 * most[name, c] || gap <= 1e-13
}

FNR == 1 { file++; head = row = 0 }
/^# / && !head { name = substr($0, 3); head = 1 }
/^$/ { head = row = 0 }
file == 1 {
    if (head && !/^#/ && row++) {
        n = split($0, cell, "\t")
        for (c = 1; c <= n; c++)
            if (number(cell[c]) && size(cell[c]) > most[name, c])
                most[name, c] = size(cell[c])
    }
    line[FNR] = $0
    lines = FNR
    next
}
{
    if ($0 != line[FNR] || !(FNR in line)) {
        n = split($0, cell, "\t")
        m = split(line[FNR], wanted, "\t")
        if (/^(#.*)?$/ || line[FNR] ~ /^(#.*)?$/ || n != m || row == 0)
            say(name " line " FNR ": " line[FNR] ", " $0)
        else
            for (c = 1; c <= n; c++)
                if (!same(wanted[c], cell[c], c) && !told[name, c]++)
                    say(name " " column[c] " row " row - 1 ": " wanted[c] ", " cell[c])
    }
    if (head && !/^#/) { if (!row) split($0, column, "\t"); row++ }
}
END {
    if (FNR != lines) say("end: " lines " lines, " FNR)
    exit different
}
