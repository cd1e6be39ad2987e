# submission.sh - a file of a class is judged, and kept to its own; grade.sh reads
# this with `.`.  FENCE is bubblewrap, or empty where that does not work; CLASS is
# the folder of the submissions.

# fenced FOLDER COMMAND...: where bubblewrap works, COMMAND changes nothing but
# FOLDER, sees nothing else of the class, and leaves nothing running.
fenced() {
    own=$1
    shift
    [ "$FENCE" ] || { "$@"; return; }
    case $BUILD in /*) at= ;; *) at=$PWD/ ;; esac
    CCACHE_DISABLE=1 "$FENCE" --unshare-all --die-with-parent --ro-bind / / \
        --dev /dev --proc /proc --tmpfs /tmp --ro-bind "$PWD" "$PWD" \
        --ro-bind "$at$BUILD" "$at$BUILD" --tmpfs "$CLASS" \
        --tmpfs "$at${own%/*}" --bind "$at$own" "$at$own" --chdir "$PWD" "$@"
}

# unjudged FOLDER WORD: why is on stdin.
unjudged() {
    cat >"$1/said"
    echo "$2 - - -" >"$1/result"
    report "${1##*/*.}" "$(cat "$1/name")" "$(echo "$2" | tr '-' ' ')" '' '' \
        <"$1/said" >"$1/report"
}
# row FOLDER: its result as a row, FOLDER/row, and a line for the teacher.
row() {
    read -r word check slot mistakes <"$1/result"
    word=$(echo "$word" | tr '-' ' ')
    printf '%s\n' "$(cat "$1/student")$tab${1##*/*.}$tab$word$tab$check$tab$slot$tab$mistakes" \
        >"$1/row"
    printf '  %-10s %s\n' "$word" "$(cat "$1/name")"
}

# one FOLDER: the verdict on the program in it.
one() {
    slug=${1##*/*.}
    if [ -f "$1/twice" ]; then
        echo 'More than one file of this lesson: none is judged.' |
            unjudged "$1" two-files
    else
        fenced "$1" sh tests/tools/student.sh grade "$slug" "$1/$slug.c" \
            "$(cat "$1/name")" "$1"
        find "$1" -type l -exec rm -f {} + # none is followed
        said=$(cat "$1/said" 2>&1)
        [ -s "$1/result" ] || echo "$said" | unjudged "$1" not-judged
    fi
    row "$1"
}

# state FOLDER: sums, modes and times of what a judgement rests on, and of the
# class but for FOLDER.
state() {
    find Makefile common solutions tests "$BUILD/solutions" "$BUILD/checks" \
        "$work"/[0-9]* -path "$1" -prune -o -exec ls -ldn {} + -type f -exec cksum {} + 2>&1
}
# Without a fence FOLDERS are judged in turn: so it is known who changes what is
# not his, and that is put back.
in_turn() {
    kept=$work/kept
    mkdir -p "$kept/book" "$kept/class" "$kept/built" &&
        cp -pR Makefile common solutions tests "$kept/book" &&
        cp -pR "$BUILD/solutions" "$BUILD/checks" "$kept/built" &&
        cp -pR "$work"/[0-9]* "$kept/class" || exit 2
    for folder in "$@"; do
        before=$(state "$folder")
        patiently sh tests/tools/grade.sh one "$folder"
        if [ "$(state "$folder")" != "$before" ]; then
            chmod -R u+rwX Makefile common solutions tests
            cp -pR "$kept/book/." .
            cp -pR "$kept/built/." "$BUILD"
            cp -pR "$kept/class/." "$work"
            [ "$(state "$folder")" = "$before" ] ||
                fail "$(cat "$folder/name") changed what others are judged by"
            echo 'While it was judged, files of the workbook or of others changed.' |
                unjudged "$folder" not-judged
            row "$folder"
        fi
        cp -pR "$folder" "$kept/class"
    done
}
