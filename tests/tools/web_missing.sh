#!/bin/sh
# web_missing.sh [COMMAND...] - what `make web` needs, and these commands, of what is
# not here: a list in words, or nothing.
set -u
missing=
for name in emscripten=emcc node=node pandoc=pandoc "$@"; do
    command -v "${name#*=}" >/dev/null 2>&1 || missing="$missing, ${name%=*}"
done
node tests/tools/web_small.js >/dev/null 2>&1 || missing="$missing, svgo"
node tests/tools/web_editor.js >/dev/null 2>&1 || missing="$missing, CodeMirror and esbuild"
[ -f "${BUILD:-build}/source/node_modules/@yowasp/clang/gen/bundle.js" ] ||
    missing="$missing, clang for the page"
[ -n "$(sh tests/tools/web_gsl.sh source)" ] || missing="$missing, GSL's source"
echo "${missing#, }"
