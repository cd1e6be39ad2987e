#!/bin/sh
# workbook.sh fill|check [FILE] - fill the generated parts of workbook.md, or
# say whether they are stale (exit status 1, with the lines that differ).
set -u
file=${2:-workbook.md}
new=$(mktemp) || exit 2
trap 'rm -f "$new"' EXIT
awk -f tests/tools/workbook.awk -v data="${BUILD:-build}/data" "$file" >"$new" ||
    exit 2
if cmp -s "$new" "$file"; then
    echo "  book     $file is up to date"
    exit 0
fi
if [ "$1" = fill ]; then
    cp "$new" "$file.part" && mv "$file.part" "$file" &&
        echo "  book     $file is filled"
else
    diff "$file" "$new" | head -n 20
    echo "$file is stale: make workbook"
    exit 1
fi
