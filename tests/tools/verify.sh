#!/bin/sh
# verify.sh KIND NN_slug - claims about a lesson's own material.
# verify.sh book - the book is in step with the programs.
# verify.sh figure PICTURE DATA - a figure is drawn from its data or can be; PICTURE
# stays as it is, and the one that is drawn is $BUILD/test/PICTURE.
#
# Prints lines "ok WHAT" and "FAIL WHAT: why" and exits with 0; the Makefile
# counts the lines.  KIND is solution, starter, mistakes or behave.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
kind=$1 slug=${2:-} name=${2:-}
nn=${slug%%_*}
judge_one() { # judge_one JUDGE [OPTIONS]: its verdict block
    one=$1
    shift
    "$one" "$@" --file "$kind $name" --reference "$BUILD/solutions/$slug" \
        --mistakes "$BUILD/mistakes/$slug" 2>&1
}
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok $2"; else echo "FAIL $2: $3"; fi
}

case $kind in
book)
    said=$(sh tests/tools/workbook.sh check)
    result $? 'the book is in step with the programs' "$said" ;;
figure)
    script=${2%.*}.gp
    cp "$2" "$BUILD/test/$2" &&
        said=$(sh tests/tools/figure.sh "$script" "$3" "$BUILD/test/$2" 2>&1)
    result $? "figure $script" "$said" ;;
solution)
    # with a 1 for each prediction, which changes no verdict
    mkdir -p "$BUILD/test"
    guess=$BUILD/test/$slug.guess.c
    sed 's/^\( \* PREDICT .*: \)\.\.\.$/\11/' "solutions/$slug.c" >"$guess"
    said=$(judge_one "$BUILD/solutions/$slug.judge" --source "$guess")
    [ "$(echo "$said" | tr '\n' ' ' | tr -s ' ' | grep -o ': 1, measured' | wc -l)" -eq \
        "$(grep -c '^ \* PREDICT ' "$guess")" ]
    result $? "$nn: every prediction is measured" "$said"
    rm -f "$guess"
    echo "$said" | awk -v nn="$nn" '/^  ok / || /^  [A-Z]+  / {
        for (i = 2; i <= NF; i++) print ($1 == "ok" ? "ok " : "FAIL ") nn ": " $i }'
    echo "$said" | grep -q "^VERDICT $nn: OK"
    result $? "$nn: solution is judged OK" "$said"
    [ "$(echo "$said" | wc -l)" -le 24 ]
    result $? "$nn: the verdict fits on one screen" "$(echo "$said" | wc -l) lines"
    tables=$("$BUILD/solutions/$slug" | awk 'NF == 0 { inside = 0; next }
        !inside { inside = 1; print $2 }')
    [ "$(echo "$tables" | wc -l)" -le 6 ]
    result $? "$nn: the default run prints at most 6 tables" "$tables" ;;
starter)
    said=$(judge_one "$BUILD/starters/$slug.judge")
    first=$(sed -n 's|.*/\* SLOT \([0-9]*[a-z]\)(.*|\1|p' "solutions/$slug.c" | head -n 1)
    echo "$said" | tail -n 1 | grep -q "^VERDICT $nn: UNFINISHED (slot "
    result $? "$nn: untouched starter is UNFINISHED" "$said"
    echo "$said" | tail -n 1 | grep -q "(slot $first)"
    result $? "$nn: the starter's verdict names slot $first" "$said"
    # the starter is the one that the solution gives: in the tree or, where a
    # student's own work has its place there, as committed
    wanted=$(awk -f tests/tools/starter.awk "solutions/$slug.c")
    [ "$(cat "lessons/$slug.c")" = "$wanted" ] ||
        [ "$(git show ":lessons/$slug.c" 2>/dev/null)" = "$wanted" ]
    result $? "$nn: starter is in step with its solution" "make starters" ;;
mistakes)
    # each is judged with what the lesson's programs print, which is kept
    all=$BUILD/mistakes/$slug kept=$BUILD/test/kept/$slug
    rm -rf "$kept" && mkdir -p "$kept"
    set -- "$BUILD/solutions/$slug"
    for why in "$all"/*.why; do set -- "$@" "${why%.why}"; done
    "$BUILD/solutions/$slug.judge" --keep "$kept" "$@"
    while read -r number kind name slot; do
        echo "entry $number $kind $name $slot"
        set -- --kept "$kept"
        [ $kind = equivalent ] || set -- "$@" --as "$name"
        [ ! -f "$all/$name.judge" ] || judge_one "$all/$name.judge" "$@" </dev/null
    done <"$all/list" | awk -v nn="$nn" -f tests/tools/verify.awk \
        "tests/mistakes/$slug.txt" - ;;
behave)
    # behave WHAT LINE VERDICT: LINE as the first line of the first slot
    with_line() {
        awk -v line="$1" '{ print }
            !done && /\/\* SLOT / { inside = 1 }
            inside && /\*\// { print line; inside = 0; done = 1 }' \
            "solutions/$slug.c"
    }
    said() { # said WHAT VERDICT
        echo "$said" | tail -n 1 | grep -q "^VERDICT $nn: $2"
        result $? "$nn: $1 is judged $2" "$said"
    }
    crash='int *volatile nowhere = (int *)-4096L; *nowhere = 1;'
    quit='extern void exit(int); exit(0);'
    # the whole way of a student, in a copy of the workbook; it is the same in all
    # lessons
    copy=$BUILD/test/copy.$nn
    BUILD="$BUILD" sh tests/tools/copy.sh "$copy" "$slug" || exit 1
    cd "$copy" || exit 1
    mine=lessons/$slug.c
    behave() {
        with_line "$2" >"$mine"
        judged "$1" "$3"
    }
    judged() {
        said=$("$MAKE" "check-$nn" 2>/dev/null </dev/null | grep -v "^next: ")
        said "$1" "$2"
    }
    behave 'segmentation fault' "$crash" CRASHED
    behave 'endless loop' 'for (volatile int spin = 0;; spin = 1) {}' TIMEOUT
    behave 'endless output' \
        'extern int puts(const char *); for (;;) puts("and on and on");' CRASHED
    behave 'early exit(0)' "$quit" CRASHED
    behave 'compile error' 'this is not C' 'WRONG (does not compile)'
    : >"$mine"
    judged 'empty file' 'UNFINISHED (empty file)'
    cp "solutions/$slug.c" "$mine"
    judged 'the solution' OK
    said=$("$MAKE" status)
    echo "$said" | grep -q "^  $slug  *passed"
    result $? "$nn: status remembers a pass" "$said"
    echo '/* edited */' >>"$mine"
    said=$("$MAKE" status)
    echo "$said" | grep -q "^  $slug  *changed since it passed"
    result $? "$nn: an edit reopens the lesson" "$said"
    cd - >/dev/null && rm -rf "$copy" ;;
esac
exit 0
