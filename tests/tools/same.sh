#!/bin/sh
# same.sh KIND - are the numbers of the build KIND (tests/same.mk) those of the
# others?  KIND is here: are the figures drawn from this machine's own numbers,
# byte by byte, those in figures/?  Only where gnuplot is the one that drew them.
# The sums at the end of a picture (figure.sh) are not compared.
#
# The tables of its RUNS against those of v8, cell by cell (same.awk); the book,
# filled from them, against the book; and every figure of SCRIPTS, drawn from them,
# against the one drawn from this machine's own, byte by byte.  What was not run
# has this machine's tables there.  A claim that does not hold has left an empty
# table.  Prints ok and FAIL lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
kind=$1 test=$BUILD/test dir=$BUILD/test/$1/data
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok $kind: $2"; else echo "FAIL $kind: $2: $3"; fi
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
        drawn=$test/figures.$(echo "$script" | tr / .).svg
        if [ -f "$drawn" ]; then
            are_the_same "$drawn" "figures/$script.svg"
            result $? "figure $script is that of figures/" \
                "rm figures/$script.svg; make figures"
        fi
    done
    exit
fi
if [ "$kind" = v2 ]; then echo 'skip same numbers by clang: not here'; fi
book=$test/$kind/book
rm -rf "$book" && mkdir "$book" && cp -Rp "$BUILD/data" "$book"
for run in $RUNS; do
    data=$run.tsv
    cp -p "$dir/$data" "$book/data/$data"
    [ -s "$dir/$data" ]
    result $? "$run runs, and what it claims holds" "$(cat "$dir/$data.said")"
    [ "$kind" != v8 ] && [ -s "$dir/$data" ] || continue
    said=$(awk -f tests/tools/same.awk "$test/v8/data/$data" "$dir/$data")
    result $? "the tables of $run are those of v8" "$said"
done
said=$(BUILD=$book sh tests/tools/workbook.sh check)
result $? 'the book is in step' "$said"
for script in $SCRIPTS; do
    study=${script%_all}
    [ -f "figures/$study.c" ] || study=${script%/*}
    cmp -s "$book/data/$study.tsv" "$BUILD/data/$study.tsv" ||
        for drawn in "$test"/figures.$(echo "$script" | tr / .).*; do
            case $drawn in *.svg | *.gif) ;; *) continue ;; esac
            said=$(sh tests/tools/figure.sh "figures/$script.gp" "$book/data/$study.tsv" \
                "$book/picture.${drawn##*.}" 2>&1) &&
                are_the_same "$book/picture.${drawn##*.}" "$drawn"
            result $? "figure $script is the same" "$said"
        done
done
rm -rf "$book"
