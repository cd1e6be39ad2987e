# progress.sh - for student.sh, which reads it with `.`: what of a student's is
# begun, passed, and to be judged; `make status`, and `make check` of all lessons.

begun() { [ -s "$mine" ] && ! starter "$slug" | cmp -s - "$mine"; }

# Behind the last verdict's word, failed check and slot stand the sums of the file
# that was judged and of what judged it; where one is another now, that is `old`.
judges() { cat "solutions/$slug.c" "tests/checks/$slug.c" tests/checks/[a-z]*; }
last_result() {
    word= failed= at= of= by= old=
    [ -f "$state.result" ] || return 0
    { read -r word failed at rest; read -r of; read -r by; } <"$state.result"
    [ "$of" = "$(sum "$mine")" ] || old='your file'
    [ "$by" = "$(judges | cksum)" ] || old='the lesson'
}
passed() { last_result; [ "$word$old" = OK ]; }

# The lessons of the course, then the rooms beside it.
status() {
    echo 'The course:'
    for file in $(sh tests/tools/workbook.sh course) rooms \
        $(sh tests/tools/workbook.sh rooms); do
        if [ "$file" = rooms ]; then
            echo 'Rooms beside it (each is entered from a lesson of the course):'
            continue
        fi
        lesson "$(basename "$file" .md)"
        if ! begun; then
            say='not begun'
        elif passed; then
            say=passed
        elif [ -n "$word" ] && [ "$old" = 'the lesson' ]; then
            say='judge again: lesson changed'
        elif [ "$word" = OK ]; then
            say='changed since it passed'
        elif [ -n "$word" ]; then
            say="last verdict $word"
        else
            say='not checked yet'
        fi
        hand=
        [ ! -f "figures/$slug/hand.c" ] || hand=" (make live-$nn)"
        printf '  %-26s %-27s %s\n' "$slug" "$say" "$(title "$slug")$hand"
    done
}

# All lessons that were begun, where the file or the lesson is another than at the
# last verdict, and a table of all verdicts.
check_all() {
    [ -z "$JSON" ] || { echo 'JSON= is for one lesson: make check-07' >&2; exit 2; }
    table= worst=0
    for file in solutions/[0-9][0-9]_*.c; do
        lesson "$(basename "$file" .c)"
        begun || continue
        last_result
        if [ -z "$word" ] || [ -n "$old" ]; then
            check
            echo
            last_result
        fi
        [ "$at" != - ] || at=
        case $word in
        OK) failed= ;;
        '') word='not judged' worst=2 ;;
        *) [ $worst = 2 ] || worst=1 ;;
        esac
        table="$table$(printf '  %-26s %-12s %s' "$slug" "$word" \
            "$failed${at:+ (slot $at)}")
"
    done
    printf %s "${table:-You have not begun a lesson yet.
}" | sed 's/ *$//'
    return $worst
}
