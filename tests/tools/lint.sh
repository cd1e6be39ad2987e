#!/bin/sh
# lint.sh - rules of the tree that a compiler does not know.
#
# Prints "ok lint: RULE" or "FAIL lint: RULE: where".
set -u
rule() { # rule NAME OFFENDERS
    if [ -z "$2" ]; then echo "ok lint: $1"; else echo "FAIL lint: $1: $2"; fi
}
sources=$(ls common/*.[ch] solutions/*.c tests/*/*.[ch])
lessons=$(for f in solutions/[0-9][0-9]_*.c; do basename "$f" .c; done)

# ---- who may include whom ----------------------------------------------------
# Layers of common/, lowest first; a file includes its own layer or lower ones.
layers='status clock tensor material banded matrix poisson bar stretch bar_fast mesh body step scene study options table'
bad=$(for file in common/*.[ch]; do
    name=$(basename "$file" | sed 's/\..$//')
    below=$(echo " $layers " | sed "s/ $name .*/ $name/")
    sed -n 's/^#include "\(.*\)\.h".*/\1/p' "$file" | while read -r used; do
        case "$below " in *" $used "*) ;; *) echo "$file includes $used.h" ;; esac
    done
done)
rule 'common/ includes downwards only' "$bad"
rule 'every header of common/ has its layer' "$(for f in common/*.h; do
    n=$(basename "$f" .h)
    case " $layers " in *" $n "*) ;; *) echo "$f" ;; esac
done)"
rule 'common/ knows no lesson' \
    "$(grep -nE '[0-9][0-9]_[a-z]|lessons/|solutions/' common/*.c common/*.h)"
rule 'solutions include libc, GSL and common/ only' \
    "$(grep -nH '^#include "' solutions/*.c | while IFS=: read -r file line text; do
        header=$(echo "$text" | sed 's/.*"\(.*\)".*/\1/')
        [ -f "common/$header" ] || echo "$file:$line"
    done)"
rule 'only options, study, table and status print in common/' \
    "$(grep -lE '\b(printf|puts|putchar|fputs|fprintf)\(' common/*.c |
        grep -vE 'common/(options|study|table|status)\.c')"

# ---- shape of the code --------------------------------------------------------
rule 'lines of at most 80 columns' \
    "$(for f in $sources; do awk -v f="$f" 'length > 80 { print f ":" FNR }' "$f"; done)"
rule 'no // comments' "$(grep -nE '(^|[^:"])//' $sources)"
rule 'no -ffast-math anywhere' "$(grep -nE 'fast-math *$|-Ofast' Makefile)"

# ---- equation labels ----------------------------------------------------------
defined=$(sed -n 's/^| \[\([a-z]*:[A-Za-z0-9-]*\)\] |.*/\1/p' workbook.md)
cited=$(cat common/*.[ch] solutions/*.c tests/checks/*.c tests/bench/*.c | tr '\n' ' ' |
    grep -oE '\[(eq|alg):[A-Za-z0-9-]+\]' | tr -d '[]' | sort -u)
rule 'no equation label is defined twice' "$(echo "$defined" | sort | uniq -d)"
rule 'every label cited by code is defined in workbook.md' \
    "$(for c in $cited; do echo "$defined" | grep -qxF "$c" || echo "$c"; done)"
rule 'every label of workbook.md is cited by code' \
    "$(for d in $defined; do echo "$cited" | grep -qxF "$d" || echo "$d"; done)"
rule 'every label cited in workbook.md is defined there' \
    "$(grep -oE '\[(eq|alg):[A-Za-z0-9-]+\]' workbook.md | tr -d '[]' | sort -u |
        while read -r c; do echo "$defined" | grep -qxF "$c" || echo "$c"; done)"

# ---- each lesson is whole -----------------------------------------------------
for slug in $lessons; do
    nn=${slug%%_*}
    missing=
    for file in "lessons/$slug.c" "tests/checks/$slug.c" "tests/mistakes/$slug.txt"; do
        [ -f "$file" ] || missing="$missing $file"
    done
    ls figures/"$slug"_*.gp >/dev/null 2>&1 || missing="$missing figure"
    grep -q "^## Lesson $nn: " workbook.md || missing="$missing chapter"
    grep -q '^ \* Plot: ' "solutions/$slug.c" || missing="$missing Plot:line"
    list=tests/mistakes/$slug.txt
    [ "$(grep -c '^mistake: ' "$list")" -ge 5 ] || missing="$missing five-mistakes"
    grep -q '^verdict: NONFINITE' "$list" || missing="$missing NONFINITE-mistake"
    grep -q '^equivalent: ' "$list" || missing="$missing equivalent-program"
    chapter=$(awk -v lesson="$nn" '/^## / { here = ($0 ~ "^## Lesson " lesson) } here' workbook.md)
    for slot in $(sed -n 's|.*/\* SLOT \([0-9]*[a-z]\)(.*|\1|p' "solutions/$slug.c"); do
        for level in 1 2 3; do
            printf '%s\n' "$chapter" | grep -q "<summary>Hint $level: slot $slot" ||
                missing="$missing hint-$level-for-$slot"
        done
    done
    printf '%s\n' "$chapter" | grep -q '<summary>Answer' || missing="$missing answer"
    rule "lesson $nn is whole" "$missing"
    rule "hints of lesson $nn name checks or slots that exist" \
        "$(printf '%s\n' "$chapter" | sed -n 's/.*<summary>Hint [123]: \([^<]*\)<.*/\1/p' |
            while read -r what; do
                case $what in
                slot*) grep -q "SLOT ${what#slot }(" "solutions/$slug.c" || echo "$what" ;;
                same_numbers_as_reference) ;;
                *) grep -q "\"$what\"" "tests/checks/$slug.c" || echo "$what" ;;
                esac
            done)"
    rule "mistakes of lesson $nn name checks that exist" \
        "$(sed -n 's/^caught-by: //p' "$list" | while read -r check; do
            [ "$check" = same_numbers_as_reference ] ||
                grep -q "\"$check\"" "tests/checks/$slug.c" || echo "$check"
        done)"
done

# ---- figures ------------------------------------------------------------------
plots=$(ls figures/*.gp | grep -vE '/(style|overlay)\.gp$')
picture() { # what a script makes
    if grep -q '^set terminal gif' "$1"; then echo "${1%.gp}.gif"; else echo "${1%.gp}.svg"; fi
}
rule 'every figure is committed' \
    "$(for f in $plots; do [ -s "$(picture "$f")" ] || echo "$f"; done)"
rule 'every figure is in workbook.md' \
    "$(for f in $plots; do grep -qF "($(picture "$f"))" workbook.md || echo "$f"; done)"
rule 'no line of text begins with a marker (Markdown would end the paragraph)' \
    "$(grep -nE '^ *<!-- n ' workbook.md)"
rule 'every picture that the text names is there' \
    "$(cat workbook.md README.md | grep -oE '\(figures/[^)]*\)' | tr -d '()' |
        while read -r f; do [ -s "$f" ] || echo "$f"; done)"
rule 'a figure that shows seconds names the machine' \
    "$(grep -lE 'seconds|\(ms\)|\(ns\)' $plots | while read -r f; do
        grep -q 'machine(' "$f" || echo "$f"; done)"
