#!/bin/sh
# workbook.sh fill|check [FILE...] - fill the generated parts of the book's
# files, or say which of them are stale (exit status 1, with the lines that
# differ).  Without FILE all files of the book.
# workbook.sh lead - fill nothing but what needs no data: the lines that lead from
# each chapter to its neighbours, and the sums of minutes in TEACHING.md.
# workbook.sh led - say where that is stale.
# workbook.sh chapters - the chapters, in the order of the book.
# workbook.sh course - the lessons of the course; workbook.sh rooms - those beside it.
set -u
LC_ALL=C
export LC_ALL
command=$1
shift
chapters="$(ls lessons/[0-9]*.md)
figures/wound/README.md
figures/robustness/README.md
figures/speed/README.md
figures/work_precision/README.md
figures/many/README.md
figures/space/README.md"
if [ "$command" = chapters ]; then echo "$chapters"; exit; fi
case $command in course | rooms)
    for file in $(ls lessons/[0-9]*.md); do
        case $command$(sed -n 's/^<!-- map \([0-9]\) .*/\1/p' "$file") in
        course1 | rooms[2-9]) echo "$file" ;;
        esac
    done
    exit ;;
lead | led) set -- $chapters lessons/TEACHING.md ;; esac
# walk: the chapters in the order in which one goes through the rooms: down the course
# (column 1 of the map), after each lesson its rooms, then what there is to read
walk() {
    awk 'FNR == 1 { if (FILENAME ~ /^figures/) place = "99 9 " ++last; else place = "" }
        /^<!-- map / && place == "" { place = $4 " " $3 " 0" }
        /^## / && place != "" && place != "-" { print place, FILENAME; place = "-" }' $chapters |
        sort -n -k 1,1 -k 2,2 -k 3,3
}
# leads: of each chapter its line to those before and behind, as FILE|LINE; a lesson of
# the course leads to the next of the course, a room to the next room, or back to the course
leads() {
    walk | awk '
        function link(from, to,    name) {
            name = to ~ /^lessons/ ? "lesson " substr(to, 9, 2) : title(to)
            if (from ~ /^lessons/ && to ~ /^lessons/) sub(/.*\//, "", to)
            else if (from ~ /^figures/ && to ~ /^figures/) sub(/^figures/, "..", to)
            else to = up to
            return "[" name "](" to ")"
        }
        function title(name,    text) {
            getline text <name
            close(name)
            sub(/^# /, "", text)
            sub(/:.*/, "", text)
            return text
        }
        { file[NR] = $4; course[NR] = $2 == 1 || $1 == 99 }
        END {
            for (k = 1; k <= NR; k++) {
                before = k - 1
                if (course[k]) while (before && !course[before]) before--
                behind = k + 1
                if (course[k]) while (behind <= NR && !course[behind]) behind++
                up = file[k] ~ /^lessons/ ? "../" : "../../"
                line = "ontents, notation and equations](" up "workbook.md)"
                if (!before) line = "[C" line
                else line = "Previous: " link(file[k], file[before]) " | [c" line
                if (behind <= NR) line = line " | next: " link(file[k], file[behind])
                print file[k] "|" line
            }
        }'
}
# minutes: "01 115 02 140 ...", from the heads of the lessons
minutes() {
    awk 'FNR == 1 { head = 1 }
        /^## / { head = 0 }
        head && match($0, /About [0-9]+( minutes|$)/) {
            split(substr($0, RSTART), word, " ")
            printf "%s %s ", substr(FILENAME, 9, 2), word[2]
            head = 0
        }' lessons/[0-9]*.md
}
if [ $# = 0 ]; then
    for file in workbook.md lessons/*.md solutions/*.md figures/*/README.md; do
        if [ -f "$file" ]; then set -- "$@" "$file"; fi
    done
fi
equations=$(grep -l '^| label | equation' workbook.md lessons/*.md)
lines=$(grep -o '<a id="alg-[^"]*"' lessons/[0-9]*.md solutions/*.md figures/*/README.md |
    sed 's/\(.*\):.*"\(.*\)"/\2 \1/')
new=$(mktemp) || exit 2
part=
trap 'rm -f "$new" "$part"' EXIT
trap 'exit 130' HUP INT TERM
said=0
minutes=$(minutes)
leads=$(leads)
leading() { # leading FILE: its line; nothing for others
    case "
$leads" in *"
$1|"*) line=${leads#*"$1|"}
        echo "${line%%
*}" ;;
    esac
}
for file; do
    part=$file.$$.part
    table=
    [ "$file" = "$equations" ] ||
        table=$(dirname "$file" | sed 's|[^/.][^/]*|..|g; s|^\.$||; s|..$|&/|')$equations
    awk -f tests/tools/workbook.awk -v data="${BUILD:-build}/data" \
        -v table="$table" -v lines="$(echo $lines)" -v leading="$(leading "$file")" \
        -v minutes="$minutes" -v only="$command" "$file" >"$new" || { said=2; continue; }
    if cmp -s "$new" "$file"; then continue; fi
    if [ "$command" != check ] && [ "$command" != led ]; then
        cp "$new" "$part" && mv "$part" "$file" || exit 2
        echo "  book     $file is filled"
    else
        diff "$file" "$new" | head -n 20
        echo "$file is stale: make workbook"
        [ $said = 2 ] || said=1
    fi
done
[ $said != 0 ] || [ "$command" = led ] || echo "  book     up to date: $# files"
exit $said
