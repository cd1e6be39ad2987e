#!/bin/sh
# deps_web.sh - install what only `make web` needs: emscripten, node-acorn, chromium
# and pandoc; and fetch svgo, CodeMirror, esbuild, clang for the page, and GSL's source
# into BUILD/source, where make clean leaves them.
#
# With apt and npm; GSL_SOURCE=, a tarball or a folder, is taken as it is.  The entry that
# apt needs for sources is made in BUILD/source for the moment, and no file of the
# system is changed.  Exit status 1 when something cannot be had.
set -u
LC_ALL=C
export LC_ALL
folder=${BUILD:-build}/source
missing=
packages='svgo@4 codemirror@6 @codemirror/lang-cpp@6 @lezer/highlight@1 esbuild@0.28
    @yowasp/clang@22.0.0-git20542-10'
packages_are_there() {
    node tests/tools/web_small.js >/dev/null 2>&1 &&
        node tests/tools/web_editor.js >/dev/null 2>&1 &&
        [ -f "$folder/node_modules/@yowasp/clang/gen/bundle.js" ]
}
for name in emscripten=emcc node-acorn= chromium=chromium pandoc=pandoc npm=npm; do
    [ $name != npm=npm ] || ! packages_are_there || continue
    command=${name#*=} package=${name%=*}
    if [ -n "$command" ]; then command -v "$command" >/dev/null 2>&1 && continue
    else [ -d "${NODE_PATH:-/usr/share/nodejs}/acorn" ] && continue; fi
    missing="$missing $package"
done
mkdir -p "$folder" || exit 1
folder=$(cd "$folder" && pwd)
source=$(sh tests/tools/web_gsl.sh source)
if [ -z "$missing" ] && [ -n "$source" ] && packages_are_there; then
    echo "  deps     all there: emscripten, node-acorn, chromium, pandoc, svgo, CodeMirror, clang, GSL's source"
    exit 0
fi
if ! command -v apt-get >/dev/null 2>&1; then
    echo "deps-web: install emscripten 3.1 with node and acorn, chromium, pandoc, and" >&2
    echo "          npm install --prefix $folder $packages; give GSL_SOURCE=, the tarball of GSL 2.7 or newer" >&2
    exit 1
fi
log=$folder/deps.log
export DEBIAN_FRONTEND=noninteractive
if [ -n "$missing" ]; then
    install="apt-get install -y --no-install-recommends$missing"
    if [ "$(id -u)" != 0 ]; then
        echo "deps-web: missing:$missing; run:  sudo apt-get update && sudo $install" >&2
        exit 1
    fi
    echo "  deps     installing$missing"
    if ! { apt-get update && $install; } >"$log" 2>&1; then
        tail -n 3 "$log" >&2
        echo "deps-web: apt-get failed; the whole log is $log" >&2
        exit 1
    fi
fi
if ! packages_are_there; then
    echo "  deps     fetching svgo, CodeMirror, esbuild and clang with npm"
    if ! npm install --prefix "$folder" $packages >"$log" 2>&1; then
        tail -n 3 "$log" >&2
        echo "deps-web: npm failed; the whole log is $log" >&2
        exit 1
    fi
    missing="$missing svgo CodeMirror esbuild clang"
fi
if [ -z "$source" ]; then
    echo "  deps     fetching GSL's source with apt-get source"
    lists=$folder/apt
    rm -rf "$lists"
    mkdir -p "$lists/parts" "$lists/lists/partial" || exit 1
    # the system's entries, for sources
    for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ ! -f "$list" ] || sed -n 's/^deb /deb-src /p' "$list"
    done >"$lists/parts/web.list"
    for list in /etc/apt/sources.list.d/*.sources; do
        [ ! -f "$list" ] || sed 's/^Types:.*/Types: deb-src/' "$list" \
            >"$lists/parts/${list##*/}"
    done
    apt() {
        apt-get -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$lists/parts" \
            -o Dir::State::lists="$lists/lists" -o APT::Sandbox::User=root \
            -o Dir::Cache::srcpkgcache= -o Dir::Cache::pkgcache= "$@"
    }
    if ! (apt update && cd "$folder" && apt source --download-only gsl) >"$log" 2>&1; then
        tail -n 3 "$log" >&2
        echo "deps-web: apt-get source failed; the whole log is $log" >&2
        exit 1
    fi
    rm -rf "$lists"
fi
[ -n "$(sh tests/tools/web_gsl.sh source)" ] || {
    echo "deps-web: GSL's source is not there" >&2
    exit 1
}
[ -n "$source" ] || missing="$missing GSL's source"
echo "  deps     installed:$missing"
