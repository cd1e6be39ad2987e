#!/bin/sh
# figure.sh SCRIPT DATA OUT [REFERENCE] - draw one figure, with the data of the
# reference in grey behind it, or leave OUT as it was.
#
# gnuplot warns and exits with 0 when data is missing, and a script that fails
# half-way leaves a truncated file; so OUT is written beside its place and moved
# there only if gnuplot said nothing and the picture is whole.
set -u
LC_ALL=C
export LC_ALL
script=$1 data=$2 out=$3
part=$out.$$.part
trap 'rm -f "$part"' EXIT
trap 'exit 130' HUP INT TERM
behind=${4:+"reference='$4';"}
said=$(gnuplot -e "data='$data'; $behind out='$part'" "$script" 2>&1)
status=$?
# of a GIF gnuplot says how many frames it has; in the C locale it has no degree
# sign of its own, which no script uses
said=$(echo "$said" | grep -v -e '^[0-9]* frames in animation sequence$' \
    -e 'iconv failed to convert degree sign')
whole() { # an SVG ends with its tag, a GIF with a semicolon
    case $out in
    *.gif) [ "$(tail -c 1 "$part")" = ';' ] ;;
    *) grep -q '</svg>' "$part" ;;
    esac 2>/dev/null
}
if [ $status -ne 0 ] || [ -n "$said" ] || ! whole; then
    echo "figure: $script failed: ${said:-no picture}" >&2
    exit 1
fi
mv "$part" "$out"
