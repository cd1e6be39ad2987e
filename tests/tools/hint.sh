# hint.sh - `make hint-NN [SLOT=12b]`; student.sh reads this file with `.`.
: "${SLOT:=}"

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

hint() {
    last_result
    if [ -z "$word$SLOT" ]; then
        echo "Run make check-$nn first: the first hint follows what fails."
        return 0
    fi
    if [ -n "$SLOT" ]; then
        failed=- at=$SLOT
    elif [ "$failed" = compile ]; then
        echo "The compiler's whole message is in $BUILD/mine/$slug.log; begin"
        echo "with its first line."
        return 0
    fi
    # the level starts again when the file or what is wrong with it changes
    key="$word $failed $at $(sum "$mine")"
    level=0
    if [ -f "$state.hint" ]; then
        read -r level last <"$state.hint"
        [ "$last" = "$key" ] || level=0
    fi
    [ "$level" -ge 3 ] || level=$((level + 1))
    text=
    if [ "$level" = 1 ] && [ "$word" != UNFINISHED ]; then
        text=$(hints 1 "$failed")
    fi
    [ -n "$text" ] || text=$(hints "$level" "slot $at")
    if [ -z "$text" ]; then
        echo 'No slot is known to be wrong. Hints for one of them:'
        sed -n "s/.*>Hint 1: slot \([0-9a-z]*\).*/  make hint-$nn SLOT=\1/p" \
            "solutions/$slug.md"
        return 0
    fi
    echo "$level $key" >"$state.hint"
    # not echo, which in dash turns \t into a tab; $ is for the typeset book
    printf '%s\n' "$text" | tr -d '$' | sed 's/\\cdot */ /g'
    if [ "$level" -lt 3 ]; then
        echo "(hint $level of 3; make hint-$nn${SLOT:+ SLOT=$SLOT} again for the next)"
    else
        echo "(hint 3 of 3; after that: make solution-$nn FORCE=1)"
    fi
}
