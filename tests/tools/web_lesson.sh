#!/bin/sh
# web_lesson.sh NN_slug CHECKS.o SITE > NN_slug.tar.gz - what the judge of a lesson needs in
# a page, beside the library: its checks, as compiled and as source, the contract and the calls
# (contract.awk), the names that are the judge's, and what the reference and the known
# mistakes print (web_kept.mjs).  SITE has the compiler and the library.
set -eu
LC_ALL=C
export LC_ALL
build=${BUILD:-build} slug=$1
work=$(mktemp -d "$build/wasi/$slug.XXXXXX")
trap 'rm -rf "$work"' 0
trap 'exit 130' 1 2 15
mkdir "$work/to" "$work/site"
cp "$2" "$work/to/checks.o"
cp "tests/checks/$slug.c" "$work/to/checks.c"
scene=figures/$slug/hand.c
[ ! -f "$scene" ] || { cp "$scene" "$work/to" && cp "solutions/$slug.c" "$work/to/solution.c"; }
for what in h calls words; do cp "$build/checks/$slug.$what" "$work/to/checks.$what"; done
packed() { tar -C "$work/to" --sort=name --owner=0 --group=0 --mtime=@0 -cf - . | gzip -9n; }
# the lesson as it is without them compiles them
ln "$3"/[cl]*.gz "$work/site"
echo '{}' >"$work/site/files.json"
echo '{"lines": [], "files": {}}' >"$work/to/checks.json"
packed >"$work/site/$slug.tar.gz"
# most of the compiler runs once: it is optimized later
node --wasm-lazy-validation --wasm-tiering-budget=100000000 tests/tools/web_kept.mjs \
    "$work/site" "$build/mistakes/$slug" >"$work/checks.json"
mv "$work/checks.json" "$work/to"
packed
