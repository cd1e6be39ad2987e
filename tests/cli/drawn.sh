#!/bin/sh
# drawn.sh - when is a picture of the tree drawn anew (tests/tools/figure.sh)?  Not
# for other digits of the same numbers, nor by another gnuplot; for all else it is.
# Prints "ok ..." or "FAIL ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok drawn: $2"; else echo "FAIL drawn: $2: $3"; fi
}
# gnuplot 6, as far as its pictures are others
real=$(command -v gnuplot)
mkdir "$tmp/bin"
cat >"$tmp/bin/gnuplot" <<END
#!/bin/sh
echo started >>'$tmp/started'
'$real' "\$@" || exit
out=\$(echo "\$2" | sed "s/.*out='\\(.*\\)'.*/\\1/")
case \$out in *.gif.*) exit ;; esac
sed -e 's/GNUPLOT 5[^<]*/GNUPLOT 6.0 patchlevel 1 /' \\
    -e 's/rotate(\\(-*[0-9]*\\))/rotate(\\1.00)/' "\$out" >'$tmp/6' && mv '$tmp/6' "\$out"
END
chmod +x "$tmp/bin/gnuplot"

# a picture by this machine's gnuplot, in place of the tree's
script=figures/10_neohookean_bar/newton.gp data=$BUILD/data/10_neohookean_bar/newton.tsv
picture=$tmp/tree.svg
scaled() { # scaled FACTOR: the data, its numbers times it
    awk -v factor="$1" 'BEGIN { FS = OFS = "\t" }
        { for (f = 1; f <= NF; f++)
              if ($f ~ /^[0-9]*\.[0-9]+/) $f = sprintf("%.17g", factor * $f)
          print }' "$data"
}
sh tests/tools/figure.sh $script "$data" "$picture"
PATH=$tmp/bin:$PATH
draw() { # draw SCRIPT DATA: over the picture; is it STARTED, and SAME?
    rm -f "$tmp/started"
    cp "$picture" "$tmp/p.svg"
    said=$(sh tests/tools/figure.sh "$1" "$2" "$tmp/p.svg" 2>&1)
    started=$([ -f "$tmp/started" ] && echo started)
    same=$(cmp -s "$picture" "$tmp/p.svg" && echo same)
}
draw $script "$data"
[ -z "$started" ] && [ -n "$same" ]
result $? 'what has not changed is not drawn' "$said $started"
scaled 1.000000000001 >"$tmp/digits.tsv"
draw $script "$tmp/digits.tsv"
! cmp -s "$data" "$tmp/digits.tsv" && [ -z "$started" ] && [ -n "$same" ]
result $? 'other digits of the same numbers draw nothing' "$said $started"
scaled 1.000002 >"$tmp/hardly.tsv"
draw $script "$tmp/hardly.tsv"
[ -n "$started" ] && [ -n "$same" ]
result $? 'numbers that look the same leave the picture, by any gnuplot' \
    "$said $started $(diff "$picture" "$tmp/p.svg" | head -n 4)"
scaled 1.1 >"$tmp/other.tsv"
draw $script "$tmp/other.tsv"
[ -n "$started" ] && [ -z "$same" ]
result $? 'other numbers are drawn' "$said $started"
{ cat $script && echo '# changed'; } >"$tmp/script.gp"
draw "$tmp/script.gp" "$data"
[ -n "$started" ] && [ "$(sed '$d' "$tmp/p.svg")" = "$(sed '$d' $picture)" ]
result $? 'a script that has changed draws, the same by any gnuplot' \
    "$said $(diff $picture "$tmp/p.svg" | head -n 4)"

moving=figures/13_backward_euler_2d/motion
for time in first second; do
    rm -f "$tmp/started"
    said=$(sh tests/tools/figure.sh $moving.gp "$BUILD/data/${moving#*/}.tsv" \
        "$tmp/p.gif" 2>&1)
    [ "$([ -f "$tmp/started" ] && echo first || echo second)" = $time ]
    result $? "what moves is drawn the first time only ($time)" "$said"
done
