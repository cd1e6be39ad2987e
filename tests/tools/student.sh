#!/bin/sh
# student.sh COMMAND [NN_slug] - what the student's make targets do.
#
# Called by the Makefile, from the top of the workbook, with BUILD and MAKE set.
# Progress is kept in $BUILD/progress, replaced files in $BUILD/saved; neither
# is touched by `make clean`.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}" "${FORCE:=}"
command=$1
slug=${2:-}
nn=${slug%%_*}
mine=lessons/$slug.c
state=$BUILD/progress/$nn
mkdir -p "$BUILD/progress" "$BUILD/saved" "$BUILD/mine"

sum() { cksum <"$1" 2>/dev/null; }
starter() { awk -f tests/tools/starter.awk "solutions/$1.c"; }
title() { sed -n '1s/^# Lesson [0-9]*[: ]*//p' "lessons/$1.md"; }

# The stamp of a pass holds the sum of the file that passed.
passed() { [ -f "$state.pass" ] && [ "$(cat "$state.pass")" = "$(sum "$mine")" ]; }

save_mine() { # keep a copy of the student's file; say where
    [ -f "$mine" ] || return 0
    copy=$BUILD/saved/$slug.$(date +%Y%m%d-%H%M%S).$$.c
    cp "$mine" "$copy" && echo "  your file is kept as $copy"
}

verdict() { # the closing line; also remembered for hint and status
    echo "$2" >"$state.result"
    echo "VERDICT $nn: $1    next: $3"
}

judge() {
    rm -f "$state.pass"
    if [ ! -f "$mine" ]; then
        echo "$mine is not there."
        verdict "UNFINISHED (no file)" "UNFINISHED - -" "make reset-$nn"
        return 1
    fi
    if ! grep -q '[^[:space:]]' "$mine"; then
        echo "$mine is empty."
        verdict "UNFINISHED (empty file)" "UNFINISHED - -" "make reset-$nn"
        return 1
    fi
    log=$BUILD/mine/$slug.log
    if ! "$MAKE" "$BUILD/solutions/$slug" \
        "$BUILD/tests/judge.o" "$BUILD/tests/output.o" \
        "$BUILD/tests/child.o" "$BUILD/tests/guard.o" >"$log" 2>&1; then
        cat "$log" >&2
        return 2
    fi
    if ! "$MAKE" "$BUILD/mine/$slug.judge" >"$log" 2>&1; then
        if ! grep -q "$slug.c:.*error" "$log"; then
            tail -n 15 "$log"
            echo "  Does the program still have its functions and its main()?"
        else
            grep -E "$slug.c:[0-9:]* (fatal )?error" "$log" | head -n 5 |
                sed "s|^.*/\(lessons/\)|  \1|"
        fi
        echo "  the whole message: $log"
        verdict "WRONG (does not compile)" "WRONG compile -" "make lesson-$nn"
        return 1
    fi
    "./$BUILD/mine/$slug.judge" --file "$mine" \
        --reference "$BUILD/solutions/$slug" \
        --mistakes "$BUILD/mistakes/$slug" \
        --prepare "'$MAKE' mistakes-$nn" \
        --result "$state.result"
    status=$?
    if [ $status = 0 ]; then sum "$mine" >"$state.pass"; fi
    return $status
}

# Sections of solutions/NN_slug.md: <details><summary>Hint 1 ...</summary>
hints() { # hints LEVEL PATTERN: the text of those whose summary has PATTERN
    awk -v level="$1" -v pattern="$2" '
        /^<details><summary>Hint / {
            title = $0
            gsub(/<[^>]*>/, "", title)
            showing = title ~ "^Hint " level && index(title, pattern)
            if (showing) print title ":"
            next
        }
        /^<\/details>/ { showing = 0 }
        showing && NF { print "  " $0 }' "solutions/$slug.md"
}

last_result() { # the last verdict's word, failed check and slot
    word= failed= at=
    if [ -f "$state.result" ]; then read -r word failed at <"$state.result"; fi
}

# The table and the two columns that the solution's header says to plot.
plot_spec() { sed -n 's/^ \* Plot: *//p' "solutions/$slug.c" | head -n 1; }

out=$BUILD/mine/$slug.tsv
run_mine() { # with limits, so that an endless loop or endless output ends
    (ulimit -t 20 -f 65536 2>/dev/null; exec "./$BUILD/mine/$slug" >"$out")
}

draw() { # in the C locale gnuplot has no degree sign of its own, and says so
    said=$(gnuplot -e "$1" figures/overlay.gp 2>&1 1>&3)
    drawn=$?
    echo "$said" | grep -v -e '^$' -e 'iconv failed to convert degree sign' >&2
    return $drawn
} 3>&1

hint() {
    last_result
    # the level starts again when the file or what is wrong with it changes
    key="$word $failed $at"
    level=0
    if [ -f "$state.hint" ]; then
        read -r level last <"$state.hint"
        [ "$last" = "$key" ] || level=0
    fi
    if [ -z "$word" ]; then
        echo "Run make check-$nn first: the first hint follows what fails."
        return 0
    fi
    [ "$level" -ge 3 ] || level=$((level + 1))
    echo "$level $key" >"$state.hint"
    text=
    if [ "$failed" = compile ]; then
        echo "The compiler's whole message is in $BUILD/mine/$slug.log; begin"
        echo "with its first line."
        return 0
    fi
    if [ "$level" = 1 ] && [ "$word" != UNFINISHED ]; then
        text=$(hints 1 "$failed")
    fi
    [ -n "$text" ] || text=$(hints "$level" "slot $at")
    [ -n "$text" ] || text=$(hints "$level" "")
    # not echo, which in dash turns \t into a tab; $ is for the typeset book
    printf '%s\n' "$text" | tr -d '$' | sed 's/\\cdot */ /g'
    if [ "$level" -lt 3 ]; then
        echo "(hint $level of 3; make hint-$nn again for the next)"
    else
        echo "(hint 3 of 3; after that: make solution-$nn FORCE=1)"
    fi
}

status() {
    for file in solutions/[0-9][0-9]_*.c; do
        slug=$(basename "$file" .c) nn=${slug%%_*}
        mine=lessons/$slug.c state=$BUILD/progress/$nn
        last_result
        if passed; then
            say=passed
        elif [ ! -s "$mine" ] || starter "$slug" | cmp -s - "$mine"; then
            say='not begun'
        elif [ "$word" = OK ]; then
            say='changed since it passed'
        elif [ -n "$word" ]; then
            say="last verdict $word"
        else
            say='not checked yet'
        fi
        printf '  %-26s %-26s %s\n' "$slug" "$say" "$(title "$slug")"
    done
}

case $command in
run)
    run_mine
    status=$?
    table=${TABLE:-$(plot_spec | cut -d ' ' -f 1)}
    awk -f tests/tools/show.awk -v show="$table" "$out"
    case $status in
    0) echo "TABLE=name shows another; all are in $out"
       echo "next: make check-$nn" ;;
    3) echo "Write the slot in $mine; make hint-$nn helps." ;;
    *) echo "The program ended with status $status. make check-$nn says more." ;;
    esac
    exit $status ;;
check)
    judge ;;
watch)
    echo "Checking $mine at each save; Ctrl-C ends."
    last=
    while :; do
        now=$(sum "$mine")
        if [ "$now" != "$last" ]; then
            last=$now
            echo
            judge || :
        fi
        sleep 1
    done ;;
plot)
    set -- $(plot_spec)
    run_mine || exit $?
    given="mine='$out'; reference='$BUILD/data/$slug.tsv'"
    given="$given; name='$1'; x='$2'; y='$3'"
    picture=$BUILD/mine/$slug.svg
    rm -f "$picture"
    draw "$given; out=''" && draw "$given; out='$picture.part'" &&
        mv "$picture.part" "$picture" &&
        echo "Table \`$1\`, $3 against $2; the picture is $picture" ;;
hint)
    hint ;;
solution)
    if passed || [ -n "$FORCE" ]; then
        cat "solutions/$slug.c"
    else
        echo "Your lesson $nn has not passed yet (make check-$nn)."
        echo "To see the solution all the same: make solution-$nn FORCE=1"
        exit 1
    fi ;;
reset)
    starter "$slug" >"$mine.part" || exit 1
    if cmp -s "$mine.part" "$mine"; then
        rm -f "$mine.part"
        echo "$mine is the starter already."
    else
        save_mine
        mv "$mine.part" "$mine"
        rm -f "$state".*
        echo "$mine is the starter again."
    fi ;;
status)
    status ;;
starters)
    shift
    for slug in "$@"; do
        mine=lessons/$slug.c
        starter "$slug" >"$mine.part" || { rm -f "$mine.part"; exit 1; }
        if cmp -s "$mine.part" "$mine"; then
            rm -f "$mine.part"
        else
            save_mine
            mv "$mine.part" "$mine"
            echo "  starter  $mine"
        fi
    done ;;
*)
    echo "student.sh: no command $command" >&2
    exit 2 ;;
esac
