#!/bin/sh
# choose.sh - `make choose SCENE=FILE [ERROR=5%] [WITHIN=33ms] [VERIFIED=yes]`.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
[ -n "$SCENE" ] || {
    echo 'make choose SCENE=FILE [ERROR=5%] [WITHIN=33ms] [VERIFIED=yes];' \
        'lessons/scenes/ has examples' >&2
    exit 2
}
error=${ERROR:-10%} within=${WITHIN:-33ms} picture=$BUILD/mine/choose
mkdir -p "$BUILD/mine"
rm -f "$picture.tsv" "$picture.svg"
"$BUILD/choose" --scene "$SCENE" --error "${error%\%}" --within "${within%ms}" \
    --verify "${VERIFIED:-no}" --picture "$picture.tsv"
status=$?
if [ -f "$picture.tsv" ] && command -v gnuplot >/dev/null; then
    sh tests/tools/figure.sh figures/scene.gp "$picture.tsv" "$picture.svg" &&
        echo "Drawn: $picture.svg"
fi
exit $status
