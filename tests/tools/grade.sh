#!/bin/sh
# grade.sh class - judge every NN_slug.c in the folders below DIR, one folder
# per student, and tabulate the verdicts in $BUILD/grade, as JSON too, and for
# Gradescope where that is the FORMAT.
#
# Called by the Makefile, with BUILD, MAKE, LESSONS and DIR set.  No link is
# followed.  A submission is copied to a folder of its own and judged there by
# student.sh, within bubblewrap where that works; what cannot be judged is said,
# and the rest is judged.
# The other commands are for this script itself: take, one.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}" "${DIR:=}" "${LESSONS:=}" "${FORMAT:=}"
: "${FENCE=bwrap}" # bubblewrap, or nothing
out=$BUILD/grade
tab=$(printf '\t')

note() { # note NAME WHAT
    printf '%s: %s' "$1" "$2" | tr '\001-\037\177' '?' >>"$work/notes"
    echo >>"$work/notes"
}
fail() { printf 'grade: %s\n' "$*" >&2; exit 2; }

# ---- collecting -------------------------------------------------------------

# take FILES...: copy those that are lessons to folders named ID.NN_slug; `work`,
# `student` (a folder) and `id` are in the environment.
take() {
    for file in "$@"; do
        shown=${file#"$DIR"/} base=${file##*/}
        # browsers number what is there already: NN_slug (1).c, NN_slug-1.c
        slug=$(printf '%s\n' "${base%.c}" |
            sed -e 's/ *([0-9]*)$//' -e 's/-[0-9]*$//')
        case $shown in
        *[[:cntrl:]]*) note "$shown" "a name with control characters"; continue ;;
        esac
        if [ -h "$file" ]; then
            note "$shown" "a link, not followed"
            continue
        fi
        case " $LESSONS " in *" $slug "*) ;; *) slug= ;; esac
        if [ -z "$slug" ] || [ "$base" = "${base%.c}" ]; then
            note "$shown" "no lesson"
        elif [ ! -f "$file" ]; then
            note "$shown" "not a plain file"
        elif [ ! -r "$file" ]; then
            note "$shown" "cannot be read"
        elif [ "$(wc -c <"$file")" -gt 1000000 ]; then
            note "$shown" "more than a megabyte"
        elif [ -d "$work/$id.$slug" ]; then
            note "$shown" "another file of this lesson"
            : >"$work/$id.$slug/twice"
        else
            mkdir "$work/$id.$slug" &&
                cp "$file" "$work/$id.$slug/$slug.c" &&
                printf '%s\n' "${student##*/}" >"$work/$id.$slug/student" &&
                printf '%s\n' "$shown" >"$work/$id.$slug/name" ||
                note "$shown" "cannot be copied"
        fi
    done
}

collect() {
    number=0
    for student in "$DIR"/* "$DIR"/.[!.]* "$DIR"/..?*; do
        name=${student##*/}
        number=$((number + 1))
        id=$(printf '%04d' $number)
        if [ -h "$student" ]; then
            note "$name" "a link, not followed"
        elif [ -d "$student" ]; then
            case $name in
            *[[:cntrl:]]*) note "$name" "a name with control characters"; continue ;;
            esac
            export work student id
            printf '%s\t%s\n' "$id" "$name" >>"$work/students"
            find "$student" ! -type d -exec sh tests/tools/grade.sh take {} + \
                2>"$work/errors" || note "$name" "$(cat "$work/errors")"
            set -- "$work/$id".*
            [ -d "$1" ] || note "$name" "nothing to judge"
        elif [ -e "$student" ]; then
            note "$name" "in no student's folder"
        fi
    done
}

# text FILE: a sum of it without blanks and comments.
text() {
    tr '\r' '\n' <"$1" | awk '
        { rest = $0
          while (rest != "") {
              at = index(rest, inside ? "*/" : "/*")
              if (!inside) print at ? substr(rest, 1, at - 1) : rest
              rest = at ? substr(rest, at + 2) : ""
              if (at) inside = !inside
          } }' | tr -d '\357\273\277[:space:]' | cksum # without blanks or a mark
}

# Which files have the text of another one or of the solution?  That of the
# starter is everybody's.  A line per text is left in $work/same, and what is
# said of each file beside it.
same() {
    for folder in "$work"/[0-9]*/; do
        slug=${folder##*/*.} slug=${slug%/}
        printf '%s\t%s\t%s\n' "$slug $(text "$folder$slug.c")" \
            "$(cat "$folder/name")" "$folder"
    done >"$work/texts"
    for slug in $(sed 's/ .*//' "$work/texts" | sort -u); do
        awk -f tests/tools/starter.awk "solutions/$slug.c" >"$work/starter"
        echo "$slug $(text "$work/starter")$tab$tab"
        echo "$slug $(text "solutions/$slug.c")${tab}solutions/$slug.c$tab"
    done >>"$work/texts"
    awk -F '\t' '
        $2 == "" { everybody[$1] }
        { name[NR] = $2; folder[NR] = $3; key[NR] = $1; count[$1]++ }
        END {
            for (i = 1; i <= NR; i++)
                if (!(key[i] in everybody) && count[key[i]] > 1)
                    group[key[i]] = group[key[i]] ", " name[i]
            for (k in group) print "\t" substr(group[k], 3)
            for (i = 1; i <= NR; i++)
                if (key[i] in group && folder[i])
                    print folder[i] "\t" substr(group[key[i]], 3)
        }' "$work/texts" >"$work/groups"
    sed -n "s/^$tab//p" "$work/groups" | sort >"$work/same"
    grep -v "^$tab" "$work/groups" | while IFS=$tab read -r folder names; do
        printf 'The same text, blanks and comments aside: %s\n' "$names" \
            >"${folder}same"
    done
}

# ---- judging ----------------------------------------------------------------

. tests/tools/submission.sh
. tests/tools/patiently.sh
. tests/tools/report.sh
clean_up() {
    trap '' INT TERM HUP QUIT # one is enough
    end_running
    rm -rf "$work"
}

judge_all() {
    set --
    for slug in $(ls "$work" | sed -n 's/^[0-9]*\.//p' | sort -u); do
        set -- "$@" "$BUILD/solutions/$slug" "$BUILD/solutions/$slug.judge" \
            "mistakes-${slug%%_*}"
    done
    [ $# -gt 0 ] || { show_notes; fail "no lesson in the folders below $DIR"; }
    patiently "$MAKE" "$@" >"$work/log" 2>&1 || {
        tail -n 5 "$work/log" >&2
        fail 'the solutions cannot be built; if a tool is missing: make deps'
    }
    set -- "$work"/[0-9]*
    echo "  judging    $# files of $(ls "$work" | sed -n 's/\..*//p' |
        grep '^[0-9]' | sort -u | wc -l | tr -d ' ') students"
    [ "$FENCE" ] || { in_turn "$@"; return; }
    for folder in "$@"; do
        set -- "$@" "$folder/judged"
        shift
    done
    patiently "$MAKE" -k "$@"
}

# ---- the tables ---------------------------------------------------------------

# cell(s) for awk: a cell of CSV; none is a formula to a spreadsheet
cell='function cell(s) {
            if (s ~ /^ *[-=+@]/ && s != "-") s = "\047" s
            if (s ~ /[",]/ || s ~ /^ | $/) { gsub(/"/, "\"\"", s); s = "\"" s "\"" }
            return s
        }'
csv() {
    awk -F '\t' -v OFS=, "$cell"'
        BEGIN { print "student,lesson,verdict,check,slot,mistake" }
        { gsub(/,/, ";", $6)
          for (c = 1; c <= 6; c++) $c = cell($c)
          print }' "$1"
}

# A row per student: the points of each lesson, as Gradescope has them, and what
# is missing to all of them.
marks() {
    for folder in "$work"/[0-9]*/; do
        at=${folder%/} at=${at##*/}
        awk -f tests/tools/json.awk -f tests/tools/gradescope.awk \
            "${folder}report" | sed -n 's/^    {"name": "[^"]*, \([^"]*\)", "score": \([01]\),.*/\1'"$tab"'\2/p' |
            sed "s/^/${at%%.*}$tab${at#*.}$tab$(cut -f 3 "${folder}row")$tab/"
    done >"$work/points"
    awk -F '\t' "$cell"'
        FILENAME ~ /students$/ { id[++n] = $1; name[$1] = $2; next }
        !($2 in most) { lesson[++m] = $2; most[$2] = 0 }
        $2 != last || $1 != whose { count = 0; last = $2; whose = $1 }
        {
            if (++count > most[$2]) most[$2] = count
            points[$1, $2] += $5
            if ($3 == "two files" || $3 == "not judged") open[$1, $2] = $3
            else if (!$5) lost[$1, $2] = lost[$1, $2] ", " $4
        }
        END {
            for (k = 2; k <= m; k++) # by number
                for (j = k; j > 1 && lesson[j] < lesson[j - 1]; j--) {
                    l = lesson[j]
                    lesson[j] = lesson[j - 1]
                    lesson[j - 1] = l
                }
            line = "student"
            for (k = 1; k <= m; k++)
                line = line "," lesson[k] " (of " most[lesson[k]] ")"
            print line ",missing"
            for (i = 1; i <= n; i++) {
                line = cell(name[id[i]])
                gone = ""
                for (k = 1; k <= m; k++) {
                    at = id[i] SUBSEP lesson[k]
                    why = open[at]
                    if (!(at in points)) why = "no file"
                    line = line "," (why == "" ? points[at] : "")
                    if (why == "") why = substr(lost[at], 3)
                    if (why != "")
                        gone = gone "; " substr(lesson[k], 1, 2) ": " why
                }
                print line "," cell(substr(gone, 3))
            }
        }' "$work/students" "$work/points"
}

# Per mistake: how many files have it; else per end: label, count, colour.
mistakes() {
    awk -F '\t' '
        $3 == "OK" || $3 ~ / / { next }
        { nn = substr($2, 1, 2) }
        $6 != "-" {
            k = split($6, name, ",")
            for (i = 1; i <= k; i++) {
                gsub(/_/, " ", name[i])
                known[nn " " name[i]]++
            }
            next
        }
        { slot = $5 == "-" ? "" : " in slot " $5 }
        $4 == "compile" { what = "does not compile" }
        $4 != "compile" { what = says[$3] slot }
        $3 == "UNFINISHED" && slot { what = "slot " $5 " not written" }
        { other[nn " " what]++ }
        BEGIN {
            says["WRONG"] = "another mistake"
            says["UNFINISHED"] = "not written"
            says["CRASHED"] = "crashes"
            says["TIMEOUT"] = "does not end"
            says["NONFINITE"] = "not finite"
        }
        END {
            for (label in known) print label "\t" known[label] "\t" 29362
            for (label in other) print label "\t" other[label] "\t" 10066329
        }' "$1" | sort -t "$tab" -k 2,2nr -k 1,1
}

# At most 40 kinds, the most frequent, by lesson.  Of kinds that are equally
# frequent all are drawn or none, unless there are more than 40 of the first.
draw() {
    picture=$out/grades.svg
    mistakes "$work/rows" >"$work/kinds"
    awk -F '\t' '
        { line[NR] = $0; count[NR] = $2 }
        END {
            n = NR < 40 ? NR : 40
            for (k = n; k && n < NR && count[k] == count[n + 1]; k--) {}
            if (k) n = k
            for (k = 1; k <= n; k++) print line[k]
        }' "$work/kinds" | sort -t "$tab" -k 1.1,1.2 -k 2,2nr -k 1,1 >"$work/most"
    if [ ! -s "$work/most" ]; then
        rm -f "$picture"
    elif ! command -v gnuplot >/dev/null 2>&1; then
        echo "  no gnuplot, so no picture: make deps" >&2
    else
        # half a row is left between lessons
        awk -F '\t' -v OFS='\t' '
            BEGIN { printf "# mistakes\nlabel\tcount\tcolour\trow\n" }
            { nn = substr($1, 1, 2) }
            NR > 1 { row += nn == last ? 1 : 1.5 }
            { last = nn; print $0, row + 0 }' "$work/most" >"$work/mistakes.tsv"
        printf '\n\n# rest\nkinds\n%d\n' \
            $(($(wc -l <"$work/kinds") - $(wc -l <"$work/most"))) \
            >>"$work/mistakes.tsv"
        sh tests/tools/figure.sh tests/tools/grade.gp "$work/mistakes.tsv" "$picture"
    fi
}

show_notes() {
    [ ! -s "$work/notes" ] || sed 's/^/  /' "$work/notes" | sort
}

summary() {
    printf '  %-26s %5s %5s  others\n' lesson files OK
    awk -F '\t' '
        { files[$2]++; count[$2, $3]++; word[$3] }
        END {
            for (lesson in files) {
                line = ""
                for (w in word)
                    if (w != "OK" && count[lesson, w])
                        line = line ", " w " " count[lesson, w]
                printf "  %-26s %5d %5d  %s\n", lesson, files[lesson],
                       count[lesson, "OK"], substr(line, 3) | "sort"
            }
        }' "$work/rows"
    mistakes "$work/rows" | awk -F '\t' '$3 == 29362' >"$work/known"
    [ ! -s "$work/known" ] || {
        echo "  known mistakes, the most frequent of $(wc -l <"$work/known" |
            tr -d ' '):"
        head -n 10 "$work/known" | awk -F '\t' '{ printf "  %5d  %s\n", $2, $1 }'
    }
    [ ! -s "$work/same" ] || {
        echo '  the same text, blanks and comments aside:'
        sed 's/^/    /' "$work/same"
    }
    for folder in "$work"/[0-9]*/; do
        [ ! -f "${folder}note" ] || while read -r line; do
            printf '    %s: %s\n' "$(cat "${folder}name")" "$line"
        done <"${folder}note"
    done >"$work/odd"
    [ ! -s "$work/odd" ] || { echo '  worth a look:'; cat "$work/odd"; }
    [ ! -s "$work/notes" ] || echo '  not judged:'
    show_notes | sed 's/^/  /'
}

# The verdicts of all as one JSON.
machines() {
    between='['
    while IFS=$tab read -r JSON_STUDENT lesson folder; do
        export JSON_STUDENT
        echo "$between"
        json "$work/$folder/report"
        between=,
    done <"$work/order"
    echo ']'
}

# A results.json for each student.
gradescope() {
    for id in $(cut -f 3 "$work/order" | sed 's/[.].*//' | sort -u); do
        set -- "$work/$id".*/report
        to=$work/gradescope/$(cat "${1%report}student")
        mkdir -p "$to" && awk -f tests/tools/json.awk \
            -f tests/tools/gradescope.awk "$@" >"$to/results.json" || exit 2
    done
    mv "$work/gradescope" "$out"
}

class() {
    case $FORMAT in '' | gradescope) ;; *)
        fail "FORMAT=$FORMAT is not known; there is FORMAT=gradescope" ;;
    esac
    [ -n "$DIR" ] || fail 'say where: make grade DIR=submissions'
    [ -d "$DIR" ] || fail "there is no folder $DIR"
    case $DIR in /* | ./* | ../*) ;; *) DIR=./$DIR ;; esac
    DIR=${DIR%/}
    export DIR
    case $(pwd -P)/ in
    "$(cd "$DIR" && pwd -P)"/*) fail "$DIR holds the workbook itself" ;;
    esac
    mkdir -p "$out" || exit 2
    [ -z "$FORMAT" ] || rm -rf "$out/gradescope"
    work=$(mktemp -d "$out/work.XXXXXX") && mkdir -p "$work/none" \
        "$BUILD/progress" "$BUILD/mine" || exit 2
    trap clean_up EXIT
    trap 'exit 130' INT TERM HUP QUIT
    export FENCE CLASS
    CLASS=$(cd "$DIR" && pwd -P)
    [ ! "$FENCE" ] || fenced "$work/none" true 2>/dev/null || FENCE=
    [ "$FENCE" ] || echo '  no bubblewrap here: a submission reads what you can' \
        'read, and without Landlock changes it'
    collect
    judge_all || fail 'some submissions are not judged'
    same
    cat "$work"/*/row | sort -t "$tab" -k 1,1 -k 2,2 >"$work/rows"
    csv "$work/rows" >"$work/csv" && mv "$work/csv" "$out/grades.csv" || exit 2
    marks >"$work/marks" && mv "$work/marks" "$out/marks.csv" || exit 2
    for folder in "$work"/[0-9]*/; do
        sed "s/^/$(basename "$folder")$tab/" "$folder/row" |
            awk -F '\t' '{ print $2 "\t" $3 "\t" $1 }'
    done | sort >"$work/order"
    while IFS=$tab read -r student lesson folder; do
        printf '== %s, %s\n' "$student" "$lesson"
        cat "$work/$folder/said"
        for also in note same; do
            [ ! -f "$work/$folder/$also" ] || cat "$work/$folder/$also"
        done
        echo
    done <"$work/order" >"$work/verdicts" &&
        mv "$work/verdicts" "$out/verdicts.txt"
    machines >"$work/json" && mv "$work/json" "$out/verdicts.json"
    [ -z "$FORMAT" ] || gradescope
    draw
    summary
    echo "  $out/marks.csv has a row per student, grades.csv one per file,"
    echo "  $out/verdicts.txt has what was said,"
    echo "  $out/grades.svg shows the mistakes; verdicts.json is for machines"
    [ -z "$FORMAT" ] || echo "  $out/gradescope/ has a results.json per student"
    ! grep -q "${tab}not judged$tab" "$work/rows"
}

case ${1:-} in
class | take | one)
    command=$1
    shift
    "$command" "$@" ;;
*)
    echo 'grade.sh: class, take, or one' >&2
    exit 2 ;;
esac
