#!/bin/sh
# same.sh KIND - are the numbers of the build KIND (tests/same.mk) those of
# the others?  KIND is here: are the figures drawn from this machine's own numbers,
# byte by byte, those in figures/?  Only where gnuplot is the one that drew them.
# The sums at the end of a picture (figure.sh) are not compared.
#
# The build is made: of v8 what is READY in the main build is taken from there, and
# ALL_NATIVE are the flags for this machine.  Then the tables of its RUNS are held
# against those of v8, cell by cell (same.awk); the book, filled from them, against the
# book; and every figure of SCRIPTS, drawn from them, against the one drawn from this
# machine's own, byte by byte.  What was not run has this machine's tables there.  A
# claim that does not hold has left no table.  Prints ok and FAIL lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}" "${CC:=cc}" "${SANITIZED:=}"
kind=$1 test=$BUILD/test build=$BUILD/test/$1 dir=$BUILD/test/$1/data
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok $kind: $2"; else echo "FAIL $kind: $2: ${3:-}"; fi
}
picture() { sed '/^<!-- drawn from/d' "$1"; }
are_the_same() { # are_the_same PICTURE PICTURE
    case $1 in
    *.gif) cmp -s "$1" "$2" ;;
    *) picture "$1" >"$test/$kind.picture" &&
           picture "$2" | cmp -s - "$test/$kind.picture" ;;
    esac
}
if [ "$kind" = here ]; then
    case $(gnuplot --version) in 'gnuplot 5.4 '*) ;; *) SCRIPTS= ;; esac
    for script in $SCRIPTS; do
        drawn=$test/figures/$script.svg
        if [ -f "$drawn" ]; then
            are_the_same "$drawn" "figures/$script.svg"
            result $? "figure $script is that of figures/" \
                "rm figures/$script.svg; make figures"
        fi
    done
    exit
fi

# ---- the build ---------------------------------------------------------------------
compiles() { # compiles FLAGS...: a program that runs
    echo 'int main(void) { return 0; }' | $CC "$@" -x c - -o "$build/try" 2>/dev/null &&
        "$build/try" && echo "$@"
}
mkdir -p "$build/common/base"
set -- $(printf "$dir/%s.tsv " $RUNS)
case $kind in
v8)
    set -- "$@" NATIVE="$ALL_NATIVE -DVEC_WIDTH=8"
    if [ -z "$SANITIZED" ]; then
        sh tests/tools/ready.sh "$build" $(printf '%s\n' $READY | grep -v /clock.o)
        ANY_FLAGS=1
        export ANY_FLAGS
    fi ;;
*)
    [ "$kind" = v2 ] || CC=clang
    initial=$(compiles -ftrivial-auto-var-init=pattern)
    checked=$(compiles -fsanitize=address,undefined -fno-sanitize-recover=all $initial)
    set -- "$@" CC="$CC" CFLAGS="-O2 $initial" NATIVE=-DVEC_WIDTH=2 \
        CHECKED="-O0 -g1 $checked" FAST_LD=
    ASAN_OPTIONS=malloc_fill_byte=255:max_malloc_fill_size=1000000000
    export ASAN_OPTIONS ;;
esac
# the clock that counts is in the place of the library's, for all that make knows
clock=$build/common/base/clock.o
$CC -std=c17 -Icommon -c tests/tools/clock.c -o "$clock.part" || exit
cmp -s "$clock.part" "$clock" || mv "$clock.part" "$clock"
"$MAKE" -k -o "$clock" BUILD="$build" V= "$@" >"$build/said" 2>&1

# ---- its tables ----------------------------------------------------------------------
if [ "$kind" = v2 ]; then echo 'skip same numbers by clang: not here'; fi
book=$test/$kind/book
rm -rf "$book" && mkdir "$book" && cp -Rp "$BUILD/data" "$book"
for run in $RUNS; do
    data=$run.tsv
    # make names only what it could not make, or had made before
    why=$(grep -v 'is up to date\.$' "$build/said" | grep -B 5 -F "$dir/$data")
    if [ ! -s "$dir/$data" ] || [ "$why" ]; then
        result 1 "$run runs, and what it claims holds" "$why"
        continue
    fi
    result 0 "$run runs, and what it claims holds"
    cp -p "$dir/$data" "$book/data/$data"
    [ "$kind" != v8 ] || continue
    said=$(awk -f tests/tools/same.awk "$test/v8/data/$data" "$dir/$data")
    result $? "the tables of $run are those of v8" "$said"
done
said=$(BUILD=$book sh tests/tools/workbook.sh check)
result $? 'the book is in step' "$said"
for script in $SCRIPTS; do
    study=${script%_all}
    [ -f "figures/$study.c" ] || study=${script%/*}
    cmp -s "$book/data/$study.tsv" "$BUILD/data/$study.tsv" ||
        for drawn in "$test/figures/$script".*; do
            case $drawn in *.svg | *.gif) ;; *) continue ;; esac
            said=$(sh tests/tools/figure.sh "figures/$script.gp" "$book/data/$study.tsv" \
                "$book/picture.${drawn##*.}" 2>&1) &&
                are_the_same "$book/picture.${drawn##*.}" "$drawn"
            result $? "figure $script is the same" "$said"
        done
done
rm -rf "$book"
