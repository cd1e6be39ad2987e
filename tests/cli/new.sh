#!/bin/sh
# new.sh - make new-98 in a copy of the workbook: the skeleton is a lesson that
# passes its checks and breaks no rule but that nothing is left to write.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok new: $2"; else echo "FAIL new: $2: $3"; fi
}
copy=$BUILD/test/new
sh tests/tools/copy.sh "$copy" 03_dirichlet_correction || exit 1
cp "$BUILD/test/lint.result" "$copy/lint.before" || exit 1
cd "$copy" || exit 1
refused() { # refused WHAT NUMBER NAME TEXT
    before=$(find . -type f | grep -c .)
    said=$("$MAKE" "new-$2" NAME="$3" 2>&1)
    [ $? = 2 ] && echo "$said" | grep -q "$4" &&
        [ "$(find . -type f | grep -c .)" = "$before" ]
    result $? "$1 is refused, and nothing is written" "$said"
}
refused 'a lesson that is there' 03 spring 'lesson 03 is there'
refused 'a lesson without a name' 98 '' 'NAME is a word'
refused 'a name with a capital' 98 Spring 'NAME is a word'
refused 'a name with a slash' 98 a/b 'NAME is a word'
refused 'a number of three digits' 198 spring 'two digits'

said=$("$MAKE" new-98 NAME=spring 2>&1)
result $? 'the files are written, filled and drawn' "$said"
! echo "$said" | grep -q 'your file'
result $? 'what is said is said to an author' "$said"
for f in solutions/98_spring.c solutions/98_spring.md lessons/98_spring.c \
    lessons/98_spring.md tests/checks/98_spring.c tests/mistakes/98_spring.txt \
    figures/98_spring/order.c figures/98_spring/order.gp \
    figures/98_spring/order.svg; do
    [ -s "$f" ]
    result $? "$f is there" 'missing or empty'
done
grep -q 'next: \[lesson 98\](98_spring.md)' lessons/*.md &&
    grep -q '^Previous: \[lesson [0-9]*\]' lessons/98_spring.md &&
    grep -q '](lessons/98_spring.md)' workbook.md &&
    grep -q '>98</text>' figures/map.svg
result $? 'neighbours, contents and map lead to it' 'they do not'
said=$("$MAKE" verify-98 2>&1)
[ "$(echo "$said" | grep -c '^  FAIL')" = 1 ] &&
    echo "$said" | grep -q '^  FAIL lint: nothing is left to write (TODO)'
result $? 'the skeleton is sound, and verify lists what is to be written' "$said"
for f in solutions/98_spring.c lessons/98_spring.md workbook.md; do
    echo "$said" | grep -q "^  $f:[0-9]*:.*TODO"
    result $? "a line of $f is on the list" "$said"
done
# lint as a whole finds no more than before, but for what is to be written
sh tests/tools/lint.sh >lint.after
said=$(grep '^FAIL' lint.after | grep -v '(TODO)\|: budget of' | cut -d : -f 2 |
    while read -r rule; do grep "^FAIL lint: $rule" lint.before >/dev/null ||
        echo "$rule"; done)
[ -z "$said" ]
result $? 'the skeleton breaks no rule of lint' "$said"
"$MAKE" check-98 2>/dev/null | tail -n 1 | grep -q '^VERDICT 98: UNFINISHED (slot 98a)'
result $? 'its starter is UNFINISHED' 'another verdict'
cd - >/dev/null && rm -rf "$copy"
