#!/bin/sh
# form.sh - the form of answers lets the skeleton of a new lesson pass, and each
# mistake that is made in it is found; so is a budget that is overdrawn, and a label
# that is not in its picture.
#
# Prints "ok form: ..." or "FAIL form: ...".
set -u
LC_ALL=C
export LC_ALL
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
rule() { # rule NAME OFFENDERS
    [ -n "$2" ] || { echo "ok form: $1"; return; }
    printf 'FAIL form: %s: %s\n' "$1" "$2"
}
of_lesson() { # of_lesson SKELETON FILE
    sed 's/@NN@/98/g; s/@N@/98/g; s/@NAME@/spring/g; s/@PLACE@/6 1/g' \
        "tests/tools/skeleton/$1" >"$2"
}
of_lesson chapter.md "$tmp/chapter.md"
of_lesson solution.md "$tmp/answers.md"
answers_say() {
    awk -f tests/tools/answers.awk "$tmp/chapter.md" "$1"
}
rule 'the skeleton of the answers has the form' "$(answers_say "$tmp/answers.md")"
found() { # found EDIT: nothing if what sed has made of the page is found
    sed "$1" "$tmp/answers.md" >"$tmp/edited"
    cmp -s "$tmp/answers.md" "$tmp/edited" && echo "$1 changes nothing"
    [ -n "$(answers_say "$tmp/edited")" ] || echo "$1"
}
rule 'an answer, a fold or a name that is missing or wrong is found' \
    "$(found 's/Answer 2: /Answer 3: /'
    found 's/Answer 2: [^<]*/Answers 2 to 4/'
    found 's/Answer 2: [^<]*/Answer 2/'
    found '/^<a id="answer-2"/d'
    found 's/^<a id="answer-2"/<a id="answer-02"/'
    found 's/^<a id="answer-2".*/&\
/'
    found 's/>Predictions</>The predictions</'
    found '/^2\. TODO: the same/d'
    found '/^<a id="predictions"/,/^<.details>/d'
    found 's/^<a id="predictions".*/The code:\
\
&/')"

# ---- budgets -------------------------------------------------------------------
tools=$PWD/tests/tools
mkdir -p "$tmp/room/tests"
printf '%s\n' one two three >"$tmp/room/a.c"
overdrawn() { # overdrawn MOST LINE-OF-CHANGELOG: what lint says of three lines
    echo "$1 lines *.c" >"$tmp/room/tests/budget.txt"
    echo "$2" >"$tmp/room/CHANGELOG.md"
    (cd "$tmp/room" && sh "$tools/budget.sh" lint)
}
rule 'a budget that is overdrawn, or raised without a word, is found' \
    "$(overdrawn 3 '- budget 3 lines *.c: it began' | grep -v '^ok'
    overdrawn 3 '- budget 4 lines *.c: it fell' | grep -v '^ok'
    overdrawn 2 '- budget 3 lines *.c: it fell' | grep '^ok'
    overdrawn 3 '- budget 2 lines *.c: it rose' | grep '^ok'
    overdrawn 3 'nothing' | grep '^ok')"

# ---- labels of axes --------------------------------------------------------------
cat >"$tmp/axes.gp" <<'X'
set xlabel "a & b < c"
if (left) { set ylabel (left ? "error of u_h (m)" : "") }
set ylabel y_name
set ylabel "error of u_h (m)"
X
labels_of() { # labels_of SVG: the labels that are not there
    printf "$1" >"$tmp/axes.svg"
    awk -f tests/tools/labels.awk "$tmp/axes.gp" "$tmp/axes.svg" | sed 's/.*"\(.*\)".*set/\1: set/'
}
texts='<text>a &amp; b &lt; c</text><text>error of u\n<text>error of u'
rule 'a label of an axis that is not in the picture is found' \
    "$(labels_of "$texts"
    [ "$(labels_of "${texts%\\n*}")" = 'error of u: set 2 times and drawn 1 times' ] || echo 'one of two'
    [ "$(labels_of "${texts#*</text>}")" = 'a &amp; b &lt; c: set 1 times and drawn 0 times' ] || echo 'none')"
