#!/bin/sh
# web.sh COMMAND - the pages for a browser, where what makes them is here.
#
# pages: for `make web`: say what is missing, or make them.  test: the same, as a line
# of a result.  small: a picture that the site cannot take fails where it is drawn, by
# node alone.  run PROGRAM...: a test of the pages, if they are made.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
export BUILD
log=$BUILD/test/web.$$.log
trap 'rm -f "$log"' EXIT
trap 'exit 130' HUP INT TERM
how='not here; make deps-web installs it'
missing() { # missing [COMMAND...]: of what is needed, in words
    missing=
    for name in emscripten=emcc node=node pandoc=pandoc "$@"; do
        command -v "${name#*=}" >/dev/null 2>&1 || missing="$missing, ${name%=*}"
    done
    node tests/tools/web_small.js >/dev/null 2>&1 || missing="$missing, svgo"
    node tests/tools/web_editor.js >/dev/null 2>&1 || missing="$missing, CodeMirror and esbuild"
    [ -f "$BUILD/source/node_modules/@yowasp/clang/gen/bundle.js" ] ||
        missing="$missing, clang for the page"
    [ -n "$(sh tests/tools/web_gsl.sh source)" ] || missing="$missing, GSL's source"
    missing=${missing#, }
    [ -n "$missing" ]
}
command=$1
shift
case $command in
pages)
    ! missing || { echo "web: $missing: $how" >&2; exit 2; }
    "$MAKE" web-pages && echo "  web      $BUILD/web/index.html" ;;
test)
    if missing chromium; then echo "skip web: $missing: $how"
    elif "$MAKE" web-pages >"$log" 2>&1; then echo 'ok web: the pages are made'
    else echo "FAIL web: the pages are not made: $(tail -n 20 "$log")"; fi ;;
small)
    if ! node tests/tools/web_small.js >/dev/null 2>&1; then
        echo "skip web: node with svgo: $how"
        exit
    fi
    node tests/web/small.mjs 2>"$log" || [ ! -s "$log" ] ||
        echo "FAIL web: tests/web/small.mjs: $(cat "$log")" ;;
run)
    grep -q '^ok ' "$BUILD/test/web-pages.result" || exit 0
    said=$("$@" 2>"$log") && { echo "$said"; exit; }
    echo "$said" | grep . && echo "$said" | grep -q '^FAIL' ||
        echo "FAIL web: $2: $(tail -n 5 "$log" | tr '\n' ' ')" ;;
esac
