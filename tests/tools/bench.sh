#!/bin/sh
# bench.sh STUDY... - `make bench`: run the studies that measure seconds.
#
# One after the other, each time anew, their tables into build/data/, and the
# pictures (TIMED) and tables with seconds in them into their place in the tree.  At
# the end stands what was wanted and what was measured; the share of a processor
# that the studies had says whether the machine was quiet.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
part=$BUILD/bench.$$.part
trap 'rm -f "$part"' EXIT
trap 'exit 130' HUP INT TERM
begin=$(date +%s)
for study in "$@"; do
    data=$BUILD/data/$study.tsv
    mkdir -p "${data%/*}"
    printf '  %-8s %s\n' bench "$study" >&2
    OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 OMP_THREAD_LIMIT=1 \
        "$BUILD/figures/$study" >"$part" && mv "$part" "$data" || exit 1
done
end=$(date +%s)
times >"$part"
processor=$(awk -v wall=$((end - begin)) -F '[ms ]+' 'NR == 2 {
    print (60 * $1 + $2 + 60 * $3 + $4) / (wall + (wall == 0)) }' "$part")
"$MAKE" peer || exit 1
set -- "$BUILD"/data/speed/*.tsv "$BUILD/data/many/peer.tsv" \
    "$BUILD/data/10_neohookean_bar/chart.tsv"
awk -f tests/tools/bench.awk -f tests/tools/seconds.awk "$@" \
    figures/speed/README.md >"$part" && cat "$part" >figures/speed/README.md || exit 1
awk -v processor="$processor" -f tests/tools/bench.awk -f tests/tools/closing.awk "$@"
command -v gnuplot >/dev/null || exit 0
for script in $TIMED; do
    sh tests/tools/figure.sh "figures/$script.gp" "$BUILD/data/${script%_all}.tsv" \
        "figures/$script.svg" || exit 1
done
