#!/bin/sh
# student.sh COMMAND [NN_slug] - what the student's make targets do; grade.sh has
# it judge other files.
#
# Called by the Makefile, from the top of the workbook, with BUILD and MAKE set.
# Progress is kept in $BUILD/progress, replaced files in $BUILD/saved; neither
# is touched by `make clean`.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}" "${FORCE:=}" "${SANITIZED:=}"
command=$1
slug=${2:-}
nn=${slug%%_*}
mine=lessons/$slug.c
state=$BUILD/progress/$nn
mkdir -p "$BUILD/progress" "$BUILD/saved" "$BUILD/mine"
case $BUILD in /*) built=$BUILD ;; *) built=./$BUILD ;; esac

sum() { [ ! -f "$1" ] || cksum <"$1" 2>/dev/null; }
starter() { awk -f tests/tools/starter.awk "solutions/$1.c"; }
title() { sed -n '1s/^# Lesson [0-9]*[: ]*//p' "lessons/$1.md"; }

# The stamp of a pass holds the sum of the file that passed.
passed() { [ -f "$state.pass" ] && [ "$(cat "$state.pass")" = "$(sum "$mine")" ]; }

save_mine() { # keep a copy of the student's file; say where
    [ -f "$mine" ] || return 0
    copy=$BUILD/saved/$slug.$(date +%Y%m%d-%H%M%S).$$.c
    cp "$mine" "$copy" && echo "  your file is kept as $copy"
}

# ---- judging: everything is done in $folder ---------------------------------

verdict() { # the closing line; also remembered for hint and status
    echo "$2" >"$folder/result"
    echo "VERDICT $nn: $1    next: $3"
}

. tests/tools/patiently.sh
clean_up() {
    end_running
    chmod -R u+rwx "$folder" 2>/dev/null
    rm -rf "$folder"
}

# compile TARGET FILE: by make, with limits, for a file may include anything
bounded=
if command -v timeout >/dev/null 2>&1; then bounded='timeout 120'; fi
compile() {
    patiently sh -c '
        { ulimit -t 60; ulimit -f 2000000; ulimit -v 4000000; } 2>/dev/null
        exec "$@"' sh $bounded "$MAKE" "$1" FILE="$2" \
        INTO="$folder/judge" SLUG="$slug" >"$folder/log" 2>&1
}
errors() { grep -E 'error|undefined reference|cannot find|not found' "$1"; }

not_your_fault() {
    {
        echo "Lesson $nn cannot be judged; your file is not the reason:"
        errors "$folder/log" >"$folder/errors" || cp "$folder/log" "$folder/errors"
        head -n 5 "$folder/errors" | sed 's/^/  /'
        echo "A tool or a library that is missing comes with: make deps"
    } >&2
    return 2
}

# The names between quotes in the log's lines that match PATTERN.
names() {
    grep -E "$1" "$folder/log" | sed -n "s/^[^'\`]*['\`]\([A-Za-z_0-9]*\)'.*/\1/p" |
        sort -u | head -n 4 | tr '\n' ' ' | sed 's/ $//; s/ /, /g'
}

# Why FILE, shown as NAME, does not compile with the checks, when the solution
# does.
explain_compile() {
    cp "$folder/log" "$folder/log.judge"
    if ! compile alone "$1"; then
        grep -F "$1:" "$folder/log" | grep -E ':[0-9]+: (fatal )?error' \
            >"$folder/errors" || errors "$folder/log" >"$folder/errors"
        head -n 5 "$folder/errors" | sed "s|^.*$1|  $2|"
        return
    fi
    mv "$folder/log.judge" "$folder/log"
    taken=$(names 'conflicting types|redefinition|redeclared|static declaration')
    twice=$(names 'multiple definition|duplicate symbol')
    needed=$(names 'implicit declaration|undeclared|undefined reference|few arg|many arg|type for arg')
    if grep -q program_main "$folder/log"; then
        echo "  main() must be there, and begin: int main(int argc, char *argv[])"
    elif [ -n "$taken" ]; then
        echo "  The checks have a name that your file has too: $taken."
        echo "  Give yours another one."
    elif [ -n "$twice" ]; then
        echo "  The library has a function that your file has too: $twice."
        echo "  Give yours another name."
    elif [ -n "$needed" ]; then
        echo "  The checks call what your file has no more, or has with other"
        echo "  parameters: $needed. The starter's functions must stay."
    else
        errors "$folder/log" | head -n 5
        echo "  Does the program still have all functions of the starter?"
    fi
}

# Every file that a judgement rests on, with its sum; of those that are not built
# also mode, owner and time.
fingerprint() {
    cksum Makefile common/*/* solutions/*.c tests/*/* \
        "$BUILD/solutions/$slug" "$BUILD/solutions/$slug.judge" 2>&1
    ls -ldn Makefile common/*/* solutions/*.c tests/*/* 2>&1
}

# judge FILE NAME [PREPARE]: the verdict on FILE, shown as NAME; 0 when it is OK,
# 2 when there is none, and the reason is not FILE.
judge() {
    if [ -e "$1" ] && [ ! -f "$1" ]; then
        echo "$2 is not a plain file."
        verdict "UNFINISHED (no file)" "UNFINISHED - - -" "make reset-$nn"
        return 1
    fi
    if [ ! -f "$1" ]; then
        echo "$2 is not there."
        verdict "UNFINISHED (no file)" "UNFINISHED - - -" "make reset-$nn"
        return 1
    fi
    if ! grep -q '[^[:space:]]' "$1"; then
        echo "$2 is empty."
        verdict "UNFINISHED (empty file)" "UNFINISHED - - -" "make reset-$nn"
        return 1
    fi
    case $(od -An -tx1 -N2 "$1" | tr -d ' ') in
    fffe | feff | 00?? | ??00)
        echo "$2 is in UTF-16. Save it as UTF-8, which compilers read."
        verdict "WRONG (UTF-16)" "WRONG compile - -" "make check-$nn"
        return 1 ;;
    esac
    patiently "$MAKE" "$BUILD/solutions/$slug" "$BUILD/solutions/$slug.judge" \
        >"$folder/log" 2>&1 || { not_your_fault; return 2; }
    if ! compile "$folder/judge" "$1"; then
        why=$(sed -n 's/^refused: //p' "$folder/log")
        if [ -n "$why" ]; then
            echo "  $2 is not judged: $why."
            verdict "WRONG (refused)" "WRONG compile - -" "make check-$nn"
            return 1
        fi
        mv "$folder/log" "$folder/log.first"
        compile "$folder/judge" "solutions/$slug.c" ||
            { not_your_fault; return 2; }
        mv "$folder/log.first" "$folder/log"
        explain_compile "$1" "$2"
        [ -z "$log" ] || echo "  the whole message: $log"
        verdict "WRONG (does not compile)" "WRONG compile - -" "make check-$nn"
        return 1
    fi
    sums=$(fingerprint)
    # the judge and the checks free nothing
    [ -z "$SANITIZED" ] || export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0}"
    patiently "$built/solutions/$slug.judge" --file "$2" \
        --source "$1" --subject "$folder/judge" --work "$folder/work" \
        --reference "$BUILD/solutions/$slug" \
        --mistakes "$BUILD/mistakes/$slug" ${3:+--prepare "$3"} \
        --result "$folder/result"
    status=$?
    if [ "$(fingerprint)" != "$sums" ]; then
        {
            echo "While $2 was judged, files of the workbook changed"
            echo "(their text, mode or time):"
            { echo "$sums"; fingerprint; } | sort | uniq -u |
                awk '{ print "  " $NF }' | sort -u | head -n 9
            echo "Put them back (git status names them), and judge again."
        } >&2
        rm -f "$folder/result"
        return 2
    fi
    if [ $status -gt 1 ] && [ $status -lt 128 ]; then
        rm -f "$folder/result"
        return 2 # the judge has said why
    elif [ $status -gt 1 ] || [ ! -s "$folder/result" ]; then
        echo "  The judge was killed: does the program send signals?"
        verdict "CRASHED (it ended its judge)" "CRASHED - - -" "make hint-$nn"
        return 1
    fi
    return $status
}

# Judge the student's file, and keep what comes of it.  Two of these may run at
# the same time.
check() {
    rm -f "$state.pass" "$state.result"
    log=$BUILD/mine/$slug.log
    before=$(sum "$mine")
    folder=$(mktemp -d "$BUILD/mine/$slug.XXXXXX") || return 2
    judge "$mine" "$mine" "'$MAKE' mistakes-$nn"
    status=$?
    [ ! -f "$folder/log" ] || mv -f "$folder/log" "$log"
    [ ! -s "$folder/result" ] || mv -f "$folder/result" "$state.result"
    if [ $status = 0 ] && [ "$before" = "$(sum "$mine")" ]; then
        echo "$before" >"$state.pass"
    fi
    clean_up
    return $status
}
# The same for any file: what is said, and the result, go to the folder INTO.
grade() { # grade FILE NAME INTO
    log=
    folder=$3/judging
    mkdir "$folder" || return 2
    judge "$1" "$2" >"$3/said" 2>&1
    [ ! -s "$folder/result" ] || mv "$folder/result" "$3/result"
}
folder= part=
# one signal is enough
trap 'trap "" INT TERM HUP QUIT
    [ -z "$folder" ] || clean_up
    [ -z "$part" ] || rm -f "$part"' EXIT
trap 'exit 130' INT TERM HUP QUIT

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
    [ ! -f "$state.result" ] || read -r word failed at rest <"$state.result"
}

# The table and the two columns that the solution's header says to plot.
plot_spec() { sed -n 's/^ \* Plot: *//p' "solutions/$slug.c" | head -n 1; }

out=$BUILD/mine/$slug.tsv
# limit OPTION MOST: `ulimit`, which in dash sets one limit at a time.  One that
# is there already may be lower.
limit() {
    ulimit "$1" "$2" 2>/dev/null ||
        case $(ulimit "$1" 2>/dev/null) in
        *[0-9]*) ;;
        *) echo "ulimit knows no $1 here: what never ends is yours to stop." >&2 ;;
        esac
}
run_mine() { # so that an endless loop or endless output ends
    (
        limit -t 21
        ulimit -S -t 20 2>/dev/null # a signal that has a name
        limit -f 65536
        exec "$built/mine/$slug" >"$out"
    )
    ended=$?
    case $ended in
    152) echo 'The program was ended: it computes for too long.' ;;
    153) echo "The program was ended: it prints too much; see $out" ;;
    esac >&2
    return $ended
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
    check ;;
grade)
    grade "$3" "$4" "$5" ;;
watch)
    echo "Checking $mine at each save; Ctrl-C ends."
    last=
    while :; do
        now=$(sum "$mine")
        if [ "$now" != "$last" ]; then
            last=$now
            echo
            check || :
        fi
        sleep 1
    done ;;
plot)
    set -- $(plot_spec)
    run_mine || exit $?
    given="mine='$out'; reference='$BUILD/data/$slug.tsv'"
    given="$given; name='$1'; x='$2'; y='$3'"
    picture=$BUILD/mine/$slug.svg part=$BUILD/mine/$slug.$$.part
    rm -f "$picture"
    draw "$given; out=''" && draw "$given; out='$part'" &&
        mv "$part" "$picture" &&
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
    part=$mine.$$.part
    starter "$slug" >"$part" || exit 1
    if [ -f "$mine" ] && cmp -s "$part" "$mine"; then
        rm -f "$part"
        echo "$mine is the starter already."
    else
        save_mine
        mv "$part" "$mine"
        rm -f "$state".*
        echo "$mine is the starter again."
    fi ;;
status)
    status ;;
starters)
    shift
    for slug in "$@"; do
        mine=lessons/$slug.c part=$mine.$$.part
        starter "$slug" >"$part" || exit 1
        if ! cmp -s "$part" "$mine"; then
            save_mine
            mv "$part" "$mine"
            echo "  starter  $mine"
        fi
        rm -f "$part"
    done ;;
*)
    echo "student.sh: no command $command" >&2
    exit 2 ;;
esac
