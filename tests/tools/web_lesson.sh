#!/bin/sh
# web_lesson.sh NN_slug CHECKS.o > NN_slug.tar.gz - what the judge of a lesson needs in
# a page, beside the library: its checks, as compiled and as source, the contract and the calls
# (contract.awk), the names that are the judge's, and what the reference and the known
# mistakes have printed, natively (kept.c, web_kept.js).  mistakes/NAME.judge is what the check that
# catches NAME says to it.
set -eu
LC_ALL=C
export LC_ALL
build=${BUILD:-build} slug=$1
all=$build/mistakes/$slug
work=$(mktemp -d "$build/wasi/$slug.XXXXXX")
trap 'rm -rf "$work"' 0
trap 'exit 130' 1 2 15
mkdir "$work/to" "$work/kept" "$work/mistakes"
set -- "$2" "$build/solutions/$slug"
for why in "$all"/*.why; do set -- "$@" "${why%.why}"; done
cp "$1" "$work/to/checks.o"
cp "tests/checks/$slug.c" "$work/to/checks.c"
scene=figures/$slug/hand.c
[ ! -f "$scene" ] || { cp "$scene" "$work/to" && cp "solutions/$slug.c" "$work/to/solution.c"; }
for what in h calls words; do cp "$build/checks/$slug.$what" "$work/to/checks.$what"; done
shift
"$build/solutions/$slug.judge" --keep "$work/kept" "$@" </dev/null
shift
for mistake; do
    name=${mistake##*/}
    cp "$mistake.why" "$work/mistakes"
    "$mistake.judge" --file "$name" --reference "$build/solutions/$slug" \
        --kept "$work/kept" --as "$name" --report "$work/report" \
        --work "$work/judge" >/dev/null </dev/null || :
    awk 'BEGIN { RS = "\036"; FS = "\037" }
        NR == 1 { check = $4; verdict = $3; text = $8 }
        END { if (verdict == "WRONG" || verdict == "NONFINITE") printf "%s\n%s", check, text }' \
        "$work/report" >"$work/said"
    [ "$(head -n 1 "$work/said")" != "$(head -n 1 "$mistake.why")" ] ||
        tail -n +2 "$work/said" >"$work/mistakes/$name.judge"
done
(cd "$work" && node "$OLDPWD/tests/tools/web_kept.js" kept mistakes >to/checks.json)
tar -C "$work/to" --sort=name --owner=0 --group=0 --mtime=@0 -cf - . | gzip -9n
