# goal.awk - a line about a goal of make that there is not.
#
#     awk -v goal=chek-07 -v lessons='01_slug 02_slug ...' -f tests/tools/goal.awk \
#         tests/tools/goals.txt
#
# A word that differs from a command's in one letter, or a longer word in two, is
# taken for it.
function smaller(a, b) { return a < b ? a : b }
function distance(a, b,   d, i, j) { # letters to change, to add or to leave out
    for (i = 0; i <= length(a); i++)
        for (j = 0; j <= length(b); j++)
            d[i, j] = !i ? j : !j ? i : smaller(smaller(d[i - 1, j], \
                d[i, j - 1]) + 1, d[i - 1, j - 1] + \
                (substr(a, i, 1) != substr(b, j, 1)))
    return d[length(a), length(b)]
}
function nearest(word, names,   name, m, k, d, best, found) {
    best = length(word) < 5 ? 2 : 3
    m = split(names, name, " ")
    for (k = 1; k <= m; k++) {
        d = distance(word, name[k])
        if (d < best) { best = d; found = name[k] }
    }
    return found
}
/^---/ { exit }
$1 == "make" && $2 ~ /-[0-9]/ { sub(/-[0-9]+$/, "", $2); by_number = by_number " " $2; next }
$1 == "make" { plain = plain " " $2 }
END {
    if (goal ~ /[\/.]/) { # a file that a rule needs
        print "make: *** No rule to make target '" goal "'."
        exit
    }
    word = goal
    sub(/[-_]?[0-9].*$/, "", word)
    if (match(goal, /[0-9]+/)) number = substr(goal, RSTART, RLENGTH)
    if (length(number) == 1) number = "0" number
    n = split(lessons, slug, " ")
    for (k = 1; k <= n; k++) if (index(slug[k], number "_") == 1) known = 1
    command = nearest(word, by_number (number != "" ? "" : plain))
    if (command == "")
        print "There is no " goal "; make alone says what there is."
    else if (number == "" && !index(plain " ", " " command " "))
        print "There is no " goal ": make " command "-07, for lesson 07?"
    else if (number == "")
        print "There is no " goal ": make " command "?"
    else if (known)
        print "There is no " goal ": make " command "-" number "?"
    else {
        print "There is no lesson " number ". The lessons are:"
        for (k = 1; k <= n; k++) print "  " slug[k]
    }
}
