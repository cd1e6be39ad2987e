#!/bin/sh
# cli.sh - what programs and make targets do with bad input, a full disk, a
# closed pipe, a missing file.  Prints "ok ..." or "FAIL ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok cli: $2"; else echo "FAIL cli: $2: $3"; fi
}

# ---- programs -----------------------------------------------------------------
refuses() { # refuses PROGRAM OPTIONS...: exit 2, one line, nothing on stdout
    program=$1
    shift
    "$program" "$@" >"$tmp/out" 2>"$tmp/err"
    status=$?
    what="$(basename "$program") refuses '$*'"
    [ $status = 2 ] && [ ! -s "$tmp/out" ] && [ "$(wc -l <"$tmp/err")" -eq 1 ] &&
        grep -qF -e "$1" "$tmp/err"
    result $? "$what" "status $status, stdout $(wc -c <"$tmp/out") bytes, $(cat "$tmp/err")"
}
for program in "$BUILD"/solutions/[0-9][0-9]_*; do
    case $program in *.*) continue ;; esac
    name=$(basename "$program")
    for value in 0 -3 1e9 abc 4x nan ''; do refuses "$program" --n "$value"; done
    refuses "$program" --n
    refuses "$program" --no-such-option 3
    refuses "$program" stray
    for option in $("$program" -h | sed -n 's/^  \(--[a-z]*\) .*a number from.*/\1/p'); do
        refuses "$program" "$option" nan
        refuses "$program" "$option" inf
    done
    "$program" -h >"$tmp/out" 2>"$tmp/err"
    result $? "$name -h" "status"
    if [ -w /dev/full ]; then
        "$program" >/dev/full 2>"$tmp/err"
        status=$?
        [ $status = 1 ] && grep -q 'cannot write' "$tmp/err"
        result $? "$name on a full disk is an error" "status $status"
    fi
    { (trap '' PIPE; while echo; do :; done) 2>/dev/null # until it is closed
        "$program" 2>/dev/null
        echo $? >"$tmp/status"; } | :
    [ "$(cat "$tmp/status")" != 0 ]
    result $? "$name on a closed pipe is an error" "status 0"
done

# a disk with a place for so many files, the folder of the judge among them
program=$BUILD/solutions/03_dirichlet_correction
mkdir "$tmp/disk"
for files in 2 3 4 5; do
    unshare -rm true 2>/dev/null || break
    unshare -rm sh -c "mount -t tmpfs -o nr_inodes=$files none '$tmp/disk' &&
        exec '$program.judge' --file solutions/03_dirichlet_correction.c \
            --reference '$program' --work '$tmp/disk/work'" >"$tmp/out" 2>&1
    status=$?
    [ $status = 2 ] && grep -q '^judge: cannot write .*: No space' "$tmp/out"
    result $? "the judge names a disk with room for $files files" \
        "status $status, $(tail -n 1 "$tmp/out")"
done

overflows() { # overflows NN_slug OPTIONS...: exit 1, the reason, no nan or inf
    program=$BUILD/solutions/$1
    shift
    "$program" "$@" >"$tmp/out" 2>"$tmp/err"
    status=$?
    [ $status = 1 ] && grep -q '^error: NONFINITE' "$tmp/err" &&
        ! grep -qiE '(^|	)[-+]?(nan|inf)(	|$)' "$tmp/out"
    result $? "$(basename "$program") $* overflows" "status $status, $(cat "$tmp/err")"
}
overflows 02_constitutive --F11 1e-160 --F12 0
overflows 11_newton_failure --start 1e-308

# ---- make targets, in a copy of the workbook -----------------------------------
copy=$BUILD/test/copy.cli
BUILD="$BUILD" sh tests/tools/copy.sh "$copy" || exit 1
cd "$copy" || exit 1
slug=$(basename "$(ls solutions/[0-9][0-9]_*.c | head -n 1)" .c)
nn=${slug%%_*}
awk -f tests/tools/starter.awk "solutions/$slug.c" >"lessons/$slug.c"

said=$("$MAKE" 2>&1)
[ $? = 0 ] && echo "$said" | grep -q 'make check-07'
result $? 'make alone says what there is' "$said"
said=$("$MAKE" lesson-99 2>&1)
[ $? != 0 ] && echo "$said" | grep -q "$slug"
result $? 'an unknown lesson number answers with the list' "$said"
said=$("$MAKE" "lesson-$nn" 2>&1)
[ $? != 0 ] && echo "$said" | grep -q 'unfinished: slot'
result $? 'a starter runs and says which slot is missing' "$said"
said=$("$MAKE" "solution-$nn" 2>&1)
[ $? != 0 ] && ! echo "$said" | grep -q '#include'
result $? 'the solution is not shown before a pass' "$said"
"$MAKE" "solution-$nn" FORCE=1 2>/dev/null | cmp -s - "solutions/$slug.c"
result $? 'FORCE=1 shows the solution' 'it differs'
"$MAKE" "check-$nn" >/dev/null 2>&1
for level in 1 2 3 3; do
    said=$("$MAKE" "hint-$nn" 2>&1)
    echo "$said" | grep -q "^Hint $level: slot"
    result $? "hint $level comes in its turn" "$said"
done
cp "solutions/$slug.c" "lessons/$slug.c"
"$MAKE" "check-$nn" >/dev/null 2>&1
result $? "check-$nn of a right program exits with 0" "status $?"
"$MAKE" "solution-$nn" 2>/dev/null | cmp -s - "solutions/$slug.c"
result $? 'the solution is shown after a pass' 'it differs'
said=$("$MAKE" "lesson-$nn" 2>&1)
result $? 'a right lesson runs' "$said"
said=$("$MAKE" "plot-$nn" 2>&1)
[ $? = 0 ] && grep -q '</svg>' "build/mine/$slug.svg" && echo "$said" | grep -q mine
result $? 'plot writes an SVG and draws in the terminal' "$said"
# predicted WHAT FILE ANSWERS TEXT: FILE with these answers at its PREDICT lines
# is judged OK, and TEXT stands in the verdict; no TEXT: no prediction does
predicted() {
    echo "$3" | tr ';' '\n' >"$tmp/answers"
    awk -v answers="$tmp/answers" '/^ \* PREDICT / {
            getline answer <answers; sub(/\.\.\.$/, answer) } { print }' \
        "$2" >"lessons/$slug.c"
    said=$("$MAKE" "check-$nn" 2>&1)
    status=$?
    text=$(echo "$said" | tr '\n' ' ' | tr -s ' ')
    if [ -n "$4" ]; then
        [ $status = 0 ] && echo "$text" | grep -q "VERDICT $nn: OK, all" &&
            echo "$text" | grep -qF -e "$4"
    else
        [ $status != 0 ] && echo "$text" | grep -q "VERDICT $nn: UNFINISHED" &&
            ! echo "$text" | grep -qi predicted
    fi
    result $? "predictions, $1" "$said"
}
right='1: 4, measured 4, right. 2: -0.1339746, measured -0.1339746, right. 3: 8/2,'
predicted 'right' "solutions/$slug.c" '4;-0.1339746;8/2' "$right measured 4, right."
predicted 'wrong' "solutions/$slug.c" '5;0.1339746;1e9' \
    '1: 5, measured 4, off by 25 %. 2: 0.1339746, measured -0.1339746, right but for its sign. 3: 1e9, measured 4, 2.5e+08 times as large.'
predicted 'words' "solutions/$slug.c" 'many;nan;' \
    '1: `many` is not a number, measured 4. 2: `nan` is not a number, measured -0.1339746. Notice:'
predicted 'none' "solutions/$slug.c" '...;...;' 'You predicted nothing. Notice:'
awk -f tests/tools/starter.awk "solutions/$slug.c" >"$tmp/starter.c"
predicted 'before it passes' "$tmp/starter.c" '4;-0.1339746;4' ''
cp "solutions/$slug.c" "lessons/$slug.c"
echo '/* mine */' >>"lessons/$slug.c"
"$MAKE" "reset-$nn" >/dev/null 2>&1
awk -f tests/tools/starter.awk "solutions/$slug.c" | cmp -s - "lessons/$slug.c" &&
    grep -q '/\* mine \*/' saved/*
result $? 'reset puts the starter back and keeps the file' ''
BUILD=build sh tests/tools/student.sh watch "$slug" >"$tmp/watch" 2>&1 &
watch=$!
until_watched() { # until_watched TEXT: a busy machine may take its time
    tries=0
    until grep -q "$1" "$tmp/watch" || [ $((tries += 1)) -gt 100 ]; do
        sleep 1
    done
}
until_watched "VERDICT $nn: UNFINISHED"
cp "solutions/$slug.c" "lessons/$slug.c"
until_watched "VERDICT $nn: OK"
kill $watch
wait $watch 2>/dev/null
grep -q "VERDICT $nn: UNFINISHED" "$tmp/watch" && grep -q "VERDICT $nn: OK" "$tmp/watch"
result $? 'watch checks again at a save' "$(cat "$tmp/watch")"

figure=$(grep -l '^# Reads' figures/"$slug"/*.gp | head -n 1)
picture=${figure%.gp}.svg
cp "$picture" "$tmp/before.svg"
sh tests/tools/figure.sh "$figure" no-such-file.tsv "$picture" >/dev/null 2>&1
[ $? != 0 ] && cmp -s "$picture" "$tmp/before.svg" && ! ls figures/*/*.part >/dev/null 2>&1
result $? 'a figure without its data leaves the old picture' "$(ls figures/*)"
echo 'plot nonsense' >>"$figure"
"$MAKE" "$picture" >/dev/null 2>&1
[ $? != 0 ] && cmp -s "$picture" "$tmp/before.svg" && ! ls figures/*/*.part >/dev/null 2>&1
result $? 'a figure whose script fails leaves the old picture' "$(ls figures/*)"
sed 's/-->[0-9][0-9.]*<!-- .n -->/-->999<!-- \/n -->/' lessons/ERRATA.md >stale.md
said=$(sh tests/tools/workbook.sh check lessons/ERRATA.md stale.md 2>&1)
[ $? = 1 ] && echo "$said" | grep -q '^stale.md is stale' &&
    ! echo "$said" | grep -q '^lessons/ERRATA.md is stale'
result $? 'a stale number in the book is noticed' "$said"
printf '%s\n' '# words' 'name	value' 'NOT_SPD	1.25' 'stretch	-' '' '' \
    >build/data/words.tsv
printf '%s\n' '<!-- table words words; name %d; value %.1f; value %s; value %.0f%% -->' \
    '<!-- end -->' >words.md
sh tests/tools/workbook.sh fill words.md >/dev/null 2>&1
grep -qxF '| NOT_SPD | 1.2 | 1.25 | 125 % |' words.md &&
    grep -qxF '| stretch | - | - | - |' words.md
result $? 'a word in a table is printed as it is' "$(cat words.md)"
grep -qxF '|---|---:|---:|---:|' words.md
result $? 'words in a table stand on the left, numbers on the right' "$(cat words.md)"
comma=$(locale -a 2>/dev/null | grep -iE '^(de_DE|fr_FR|tr_TR)\.utf-?8$' | head -n 1)
if [ -n "$comma" ]; then
    said=$(LC_ALL=$comma sh tests/tools/workbook.sh check lessons/ERRATA.md 2>&1)
    result $? "the book is filled alike under $comma" "$said"
    "$MAKE" "lesson-$nn" >/dev/null 2>&1
    said=$(LC_ALL=$comma "$MAKE" "lesson-$nn" 2>&1)
    [ "$said" = "$("$MAKE" "lesson-$nn" 2>&1)" ]
    result $? "a lesson is shown alike under $comma" "$said"
else
    echo 'skip cli: no locale with a decimal comma here'
fi
awk '/^\/\* SLOT|^    \/\* SLOT/ { print "    int spoiled;" } { print }' \
    "solutions/$slug.c" | awk -f tests/tools/starter.awk | cmp -s - "lessons/$slug.c"
[ $? != 0 ]
result $? 'a starter out of step is noticed' ''
cd - >/dev/null && rm -rf "$copy"
