#!/bin/sh
# workbook.sh fill|check [FILE...] - fill the generated parts of the book's
# files, or say which of them are stale (exit status 1, with the lines that
# differ).  Without FILE all files of the book.
set -u
LC_ALL=C
export LC_ALL
command=$1
shift
if [ $# = 0 ]; then
    for file in workbook.md lessons/*.md solutions/*.md figures/*/README.md; do
        if [ -f "$file" ]; then set -- "$@" "$file"; fi
    done
fi
equations=$(grep -l '^| label | equation' workbook.md lessons/*.md)
new=$(mktemp) || exit 2
part=
trap 'rm -f "$new" "$part"' EXIT
trap 'exit 130' HUP INT TERM
said=0
for file; do
    part=$file.$$.part
    table=
    [ "$file" = "$equations" ] ||
        table=$(dirname "$file" | sed 's|[^/.][^/]*|..|g; s|^\.$||; s|..$|&/|')$equations
    awk -f tests/tools/workbook.awk -v data="${BUILD:-build}/data" \
        -v table="$table" "$file" >"$new" || { said=2; continue; }
    if cmp -s "$new" "$file"; then continue; fi
    if [ "$command" = fill ]; then
        cp "$new" "$part" && mv "$part" "$file" || exit 2
        echo "  book     $file is filled"
    else
        diff "$file" "$new" | head -n 20
        echo "$file is stale: make workbook"
        [ $said = 2 ] || said=1
    fi
done
[ $said != 0 ] || echo "  book     up to date: $# files"
exit $said
