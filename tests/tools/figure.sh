#!/bin/sh
# figure.sh SCRIPT DATA OUT [REFERENCE] - draw one figure, with the data of the
# reference in grey behind it, or leave OUT as it was.
#
# A picture ends in a comment with the sums of its script, the style and its data,
# and is drawn anew only when these are others.  Numbers count with six digits
# there, and those below 1e-12 as 0, because the rest is not the same on every
# machine; and what only the version of gnuplot changes is left out of an SVG.  So
# whoever runs the course has the pictures of the tree, byte by byte.
#
# gnuplot warns and exits with 0 when data is missing, and a script that fails
# half-way leaves a truncated file; so OUT is written beside its place and moved
# there only if gnuplot said nothing and the picture is whole.
set -u
LC_ALL=C
export LC_ALL
script=$1 data=$2 out=$3
style=figures/style.gp
! grep -q 'square\.gp"' "$script" || style="$style $(echo figures/square.*)"
from= # sums, and how many bytes they are of
for word in $(awk 'BEGIN { FS = OFS = "\t" }
    { for (f = 1; f <= NF; f++)
        if (length($f) > 6 && $f ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/)
            $f = $f * $f < 1e-24 ? 0 : sprintf("%.6g", $f)
      print }' "$data" 2>/dev/null | cksum "$script" $style /dev/stdin); do
    case $word in *[!0-9]*) ;; *) from=$from$word. ;; esac
done
if [ -z "${4:-}" ] && grep -qF "drawn from $from" "$out" 2>/dev/null; then
    touch "$out" # for make
    exit
fi
mkdir -p "${out%/*}"
[ -z "${SAY:-}" ] || echo "  plot     $out"
part=$out.$$.part
trap 'rm -f "$part" "$part.new"' EXIT
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
case $out in
*.gif) # a comment of 120 bytes before the semicolon
    head -c $(($(wc -c <"$part") - 1)) "$part" >"$part.new" &&
        printf '!\376\170%-120.120s\000;' "drawn from $from" >>"$part.new" ;;
*)
    was=${from%.*.*.}
    sed -e 's/\(Produced by GNUPLOT\) .*</\1</' \
        -e 's/rotate(\(-*[0-9]*\)\.[0-9]*)/rotate(\1)/g' "$part" >"$part.new" &&
        # the same picture of other numbers stays as it is, with its old sums
        # (remove it first, where the numbers are others on every machine)
        grep -qF "drawn from $was." "$out" 2>/dev/null &&
        sed '/^<!-- drawn from/d' "$out" | cmp -s - "$part.new" &&
        touch "$out" && exit
    echo "<!-- drawn from $from -->" >>"$part.new" ;;
esac && mv "$part.new" "$out"
