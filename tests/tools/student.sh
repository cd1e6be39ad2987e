#!/bin/sh
# student.sh COMMAND [NN_slug] - what the student's make targets do; grade.sh has
# it judge other files.
#
# Called by the Makefile, from the top of the workbook, with BUILD and MAKE set.
# Progress is kept in $BUILD/progress, which `make clean` leaves alone, and files
# that are replaced in saved/, which is not below $BUILD.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}" "${FORCE:=}" "${SANITIZED:=}" "${JSON:=}"
: "${ARGS:=}" "${TABLE:=}" "${SECONDS_COMPILING:=300}"
command=$1
lesson() { slug=$1 nn=${1%%_*} mine=lessons/$1.c state=$BUILD/progress/${1%%_*}; }
lesson "${2:-}"
[ -d "$BUILD/progress" ] && [ -d "$BUILD/mine" ] ||
    mkdir -p "$BUILD/progress" "$BUILD/mine"
case $BUILD in /*) built=$BUILD ;; *) built=./$BUILD ;; esac

sum() { [ ! -f "$1" ] || cksum <"$1" 2>/dev/null; }
starter() { awk -f tests/tools/starter.awk "solutions/$1.c"; }
title() { { read -r line && echo "${line#\# Lesson ??: }"; } <"lessons/$1.md"; }

. tests/tools/progress.sh

save_mine() { # save_mine WHOSE: keep a copy of the file; say where
    [ -f "$mine" ] || return 0
    copy=saved/$slug.$(date +%Y%m%d-%H%M%S).$$.c
    { mkdir -p saved && cp "$mine" "$copy"; } || exit
    echo "  $1 is kept as $copy"
}

# ---- judging: everything is done in $folder ---------------------------------

. tests/tools/patiently.sh
. tests/tools/report.sh
clean_up() {
    end_running
    rm -rf "$folder" 2>/dev/null || {
        chmod -R u+rwx "$folder" 2>/dev/null
        rm -rf "$folder"
    }
    folder=
}

# compile FILE TARGET...: by make, with limits, for a file may include anything.
# Where its end is none of the file's, the words in the file `late` say so.
compile() {
    source=$1
    shift
    [ ! -f "$folder/late" ] || rm -f "$folder/late"
    patiently sh -c '
        { ulimit -t "$0"; ulimit -f 2000000; ulimit -v 4000000; } 2>/dev/null
        exec "$@"' "$SECONDS_COMPILING" $(within "$SECONDS_COMPILING") "$MAKE" "$@" \
        FILE="$source" INTO="$folder/judge" SLUG="$slug" >"$folder/log" 2>&1 && return
    if [ $ended = 124 ] || grep -qi 'cpu *time limit exceeded' "$folder/log"; then
        echo "not done after $SECONDS_COMPILING s"
    elif grep -qE '(^|: |[0-9] )(Terminated|Killed)( |$)' "$folder/log"; then
        echo 'ended by a signal'
    fi >"$folder/late"
    return 1
}
# build FILE: its judge, and the solution with its own.  These are nearly always
# there; when they are not, and the limits were too narrow for them as well, they
# are made without.  If that cannot be, there is a file `unready`.
build() {
    set -- "$1" "$BUILD/solutions/$slug" "$BUILD/solutions/$slug.judge"
    compile "$@" "$folder/judge" && return
    "$MAKE" -q "$2" "$3" >/dev/null 2>&1 && return 1
    : >"$folder/unready"
    rm -f "$folder/late"
    patiently "$MAKE" "$2" "$3" >"$folder/log" 2>&1 && rm "$folder/unready" &&
        compile "$1" "$folder/judge"
}
errors() { grep -E 'error|undefined reference|cannot find|not found' "$1"; }

no_build() { # why there is none, when it is not the file
    [ ! -s "$folder/late" ] || {
        echo "Lesson $nn is not judged: the compiler was $(cat "$folder/late")." \
            'Is the machine busy? Try again.' >"$folder/why"
        no_verdict "make check-$nn"
        return 2
    }
    {
        echo "Lesson $nn cannot be judged; your file is not the reason:"
        errors "$folder/log" >"$folder/errors" || cp "$folder/log" "$folder/errors"
        head -n 5 "$folder/errors" | sed 's/^/  /'
        echo "A tool or a library that is missing comes with: make deps"
    } >"$folder/why"
    no_verdict 'make deps'
}

commas() { sort -u | head -n 4 | tr '\n' ' ' | sed 's/ $//; s/ /, /g'; }
# The functions that a file defines.
heads() {
    sed -n 's/^[a-z][^;=(]*[ *]\([A-Za-z_][A-Za-z_0-9]*\)(.*/\1/p' "$1" | sort -u
}

# Whose are the names that the file declares once more?  The compiler's note says
# where that was, after the error that has the name.
declared_elsewhere() {
    awk -v quote="'" '
        /(error|warning): / { name = "" }
        /error: .*(conflicting|redeclared|redefinition|static declaration)/ {
            split($0, part, quote)
            name = part[2]
        }
        /^(\/|common\/)[^:]*\.h:.* note: previous/ && name && !told[name]++ {
            whose = /^common/ ? "the workbook" : /\/gsl\// ? "GSL" : "the C library"
            print "  " name " is a name of " whose quote "s, declared by a header" \
                " that your file includes."
            some = 1
        }
        END { if (some) print "  Give yours another name." }' "$folder/log"
}

# Why FILE, shown as NAME, does not compile with the checks, when the solution
# does.
explain_compile() {
    cp "$folder/log" "$folder/log.judge"
    if ! compile "$1" alone; then
        grep -F "$1:" "$folder/log" | grep -E ':[0-9]+: (fatal )?error' \
            >"$folder/errors" || errors "$folder/log" >"$folder/errors"
        head -n 5 "$folder/errors" | file=$1 shown=$2 awk '
            { at = index($0, ENVIRON["file"])
              print at ? "  " ENVIRON["shown"] \
                  substr($0, at + length(ENVIRON["file"])) : $0 }'
        declared_elsewhere
        return
    fi
    mv "$folder/log.judge" "$folder/log"
    missing=$(sed -n 's/^missing: //p' "$folder/log" | commas)
    other=$(sed -n 's/^the call of \([A-Za-z_0-9]*\):[0-9].*error.*/\1/p' "$folder/log" |
        commas)
    if [ "$missing" = main ] || [ "$other" = main ]; then
        echo "  main() must be there, and begin: int main(int argc, char *argv[])"
    elif [ -n "$missing" ]; then
        heads "solutions/$slug.c" >"$folder/heads"
        new=$(heads "$1" | comm -13 "$folder/heads" - | commas)
        echo "  The checks call what your file no longer has: $missing."
        [ -z "$new" ] || echo "  New in it: $new."
        echo "  Keep the names of the starter's functions."
    elif [ -n "$other" ]; then
        echo "  The checks call what in your file has other parameters, or another"
        echo "  type: $other. Keep them as in the starter."
    else
        errors "$folder/log" | head -n 5
        echo "  Does your program still have all functions of the starter?"
    fi
}

# judge FILE NAME [PREPARE]: the verdict on FILE, shown as NAME; 0 when it is OK,
# 2 when there is none, and the reason is not FILE.
judge() {
    shown=$2
    if [ -e "$1" ] && [ ! -f "$1" ]; then
        printf '%s is not a plain file.\n' "$2" >"$folder/why"
        verdict "UNFINISHED (no file)" "UNFINISHED - - -" "make reset-$nn"
        return 1
    fi
    if [ ! -f "$1" ]; then
        printf '%s is not there.\n' "$2" >"$folder/why"
        verdict "UNFINISHED (no file)" "UNFINISHED - - -" "make reset-$nn"
        return 1
    fi
    if ! grep -q '[^[:space:]]' "$1"; then
        printf '%s is empty.\n' "$2" >"$folder/why"
        verdict "UNFINISHED (empty file)" "UNFINISHED - - -" "make reset-$nn"
        return 1
    fi
    case $(od -An -tx1 -N2 "$1") in
    *ff*fe* | *fe*ff* | *00*)
        printf '%s is in UTF-16. Save it as UTF-8, which compilers read.\n' \
            "$2" >"$folder/why"
        verdict "WRONG (UTF-16)" "WRONG compile - -" "make check-$nn"
        return 1 ;;
    esac
    if ! build "$1"; then
        [ ! -f "$folder/unready" ] && [ ! -s "$folder/late" ] ||
            { no_build; return 2; }
        why=$(sed -n 's/^refused: //p' "$folder/log")
        if [ -n "$why" ]; then
            printf '  %s is not judged: %s.\n' "$2" "$why" >"$folder/why"
            verdict "WRONG (refused)" "WRONG compile - -" "make check-$nn"
            return 1
        fi
        mv "$folder/log" "$folder/log.first"
        compile "solutions/$slug.c" "$folder/judge" ||
            { no_build; return 2; }
        mv "$folder/log.first" "$folder/log"
        explain_compile "$1" "$2" >"$folder/why"
        [ -z "$log" ] || echo "  the whole message: $log" >>"$folder/why"
        verdict "WRONG (does not compile)" "WRONG compile - -" "make check-$nn"
        return 1
    fi
    # the judge and the checks free nothing
    [ -z "$SANITIZED" ] || export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0}"
    # of a class's submissions none sees the teacher's variables
    set -- "$1" "$2" "${3:-}" "$built/solutions/$slug.judge"
    [ "$command" != grade ] || set -- "$1" "$2" "$3" env -i PATH="$PATH" \
        LC_ALL=C SANITIZED="$SANITIZED" ASAN_OPTIONS="${ASAN_OPTIONS:-}" "$4"
    file=$1 prepare=$3
    shift 3
    patiently "$@" --file "$shown" \
        --source "$file" --subject "$folder/judge" --work "$folder/work" \
        --reference "$BUILD/solutions/$slug" \
        --mistakes "$BUILD/mistakes/$slug" ${prepare:+--prepare "$prepare"} \
        --result "$folder/result" --report "$folder/report" 2>"$folder/why"
    status=$?
    [ -d "$folder" ] || mkdir -p "$folder" # a program may have removed it
    [ $status -gt 1 ] && [ $status -lt 128 ] || [ ! -s "$folder/why" ] ||
        harmless <"$folder/why" >&2
    if [ $status -gt 1 ] && [ $status -lt 128 ]; then
        no_verdict '' # the judge has said why
        return 2
    elif [ $status -gt 1 ] || [ ! -s "$folder/result" ]; then
        echo "  The judge was killed: does the program send signals?" \
            >"$folder/why"
        verdict "CRASHED (it ended its judge)" "CRASHED - - -" "make hint-$nn"
        return 1
    fi
    return $status
}

# Judge the student's file, and keep what comes of it.  Two of these may run at
# the same time.
check() {
    [ ! -f "$state.result" ] || rm -f "$state.result"
    log=$BUILD/mine/$slug.log
    before=$(sum "$mine")
    json_begin
    folder=$(mktemp -d "$BUILD/mine/$slug.XXXXXX") || return 2
    judge "$mine" "$mine" "'$MAKE' mistakes-$nn >/dev/null"
    status=$?
    json_end "$folder/report" || status=2
    [ ! -f "$folder/log" ] || mv -f "$folder/log" "$log"
    if [ -s "$folder/result" ]; then
        { echo "$before"; judges | cksum; } >>"$folder/result"
        mv -f "$folder/result" "$state.result"
    fi
    clean_up
    [ $status != 0 ] || following
    return $status
}
# What comes after this lesson, as its chapter says: the next of the course, for a room
# the next room or the way back to the course, or what there is to read.
following() {
    after=$(sed -n '/^Previous: \|^\[Contents/s/.*| next: \[lesson [0-9]*\](\(.*\)\.md)$/\1/p' \
        "lessons/$slug.md")
    if [ -n "$after" ]; then
        echo "next: lesson ${after%%_*}, $(title "$after") (lessons/$after.md)"
    else
        echo 'next: that was the last lesson; to read:'
        sed -n 's/^.*\[\(.*\)\](\(figures[^)]*\)) | To read.*/  \1 (\2)/p' workbook.md
    fi
}
# The same for any file: what is said, and the result, go to the folder INTO.
grade() { # grade FILE NAME INTO
    log=
    folder=$3/judging
    mkdir "$folder" || return 2
    judge "$1" "$2" >"$3/raw" 2>&1
    harmless <"$3/raw" >"$3/said"
    [ ! -f "$folder/judge.s" ] || nm -gP "$BUILD/libworkbook.a" 2>/dev/null |
        awk -f tests/tools/note.awk - "$BUILD/solutions/$slug.judge.s" \
            "$folder/judge.s" "$folder/judge.d" >"$3/note"
    mv "$folder/report" "$3/report"
    [ ! -s "$folder/result" ] || mv "$folder/result" "$3/result"
}
folder= part=
# one signal is enough
trap 'trap "" INT TERM HUP QUIT
    [ -z "$folder" ] || clean_up
    [ -z "$part" ] || rm -f "$part"' EXIT
trap 'exit 130' INT TERM HUP QUIT

. tests/tools/numbers.sh

. tests/tools/pictures.sh

case $command in
run)
    run_mine
    status=$?
    if asked_for_help; then
        cat "$out"
        exit $status
    fi
    table=${TABLE:-$(plot_spec | cut -d ' ' -f 1)}
    awk -f tests/tools/show.awk -v show="$table" "$out"
    case $status in
    0) echo "TABLE=name shows another; all are in $out"
       echo "next: make check-$nn" ;;
    3) echo "Write the slot in $mine; make hint-$nn helps." ;;
    2) [ -z "$ARGS" ] || echo "make lesson-$nn ARGS=-h lists the options." ;;
    *) echo "The program ended with status $status. make check-$nn says more." ;;
    esac
    exit $status ;;
check)
    if [ -n "$slug" ]; then check; else check_all; fi ;;
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
diff)
    make_diff ;;
plot)
    command -v gnuplot >/dev/null || {
        echo 'gnuplot is not found; it comes with: make deps' >&2
        exit 2
    }
    make_plot ;;
pictures) # of what the last run has printed
    course_figures ;;
hint)
    . tests/tools/hint.sh
    hint ;;
debug)
    . tests/tools/debug.sh
    debug ;;
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
        save_mine "your file"
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
            save_mine "the one before"
            mv "$part" "$mine"
            echo "  starter  $mine"
        fi
        rm -f "$part"
    done ;;
*)
    echo "student.sh: no command $command" >&2
    exit 2 ;;
esac
