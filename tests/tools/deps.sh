#!/bin/sh
# deps.sh - install what is missing: a C compiler, GSL, Check, gnuplot.
#
# Uses apt-get or Homebrew, and only for what is missing; without either it
# prints what to install.  Says nothing but one line when all is there.
set -u
LC_ALL=C
export LC_ALL

have_header() { printf '#include <%s>\n' "$1" | ${CC:-cc} $2 -E - >/dev/null 2>&1; }

missing=
need() { missing="$missing $1"; }

set -- ${CC:-cc}
command -v "$1" >/dev/null 2>&1 || need compiler
command -v pkg-config >/dev/null 2>&1 || need pkg-config
case " $missing " in
*" compiler "*) need gsl; need check ;;
*)
    have_header gsl/gsl_linalg.h "$(gsl-config --cflags 2>/dev/null)" || need gsl
    have_header check.h "$(pkg-config --cflags check 2>/dev/null)" || need check ;;
esac
command -v gnuplot >/dev/null 2>&1 || need gnuplot

if [ -z "$missing" ]; then
    echo "  deps     all there: C compiler, GSL, Check, gnuplot"
    exit 0
fi

if command -v apt-get >/dev/null 2>&1; then
    names=$(for m in $missing; do
        case $m in
        compiler) echo gcc libc6-dev ;;
        gsl) echo libgsl-dev ;;
        gnuplot) echo gnuplot-nox ;;
        *) echo "$m" ;;
        esac
    done | tr '\n' ' ')
    install="apt-get install -y --no-install-recommends $names"
    if [ "$(id -u)" != 0 ]; then
        echo "deps: missing:$missing; run:  sudo apt-get update && sudo $install" >&2
        exit 1
    fi
    echo "  deps     installing $names"
    log=$(mktemp) || exit 1
    export DEBIAN_FRONTEND=noninteractive
    # what an update cannot reach may be no source of these
    if ! { apt-get update; $install; } >"$log" 2>&1; then
        why=$(sed -n -e '/^E: /{p;q;}' -e '/^W: Failed to fetch/{p;q;}' "$log")
        echo "deps: apt-get failed: $why (the whole log: $log)" >&2
        exit 1
    fi
    rm -f "$log"
elif command -v brew >/dev/null 2>&1; then
    case " $missing " in
    *" compiler "*)
        echo "deps: no C compiler; run:  xcode-select --install" >&2
        exit 1 ;;
    esac
    echo "  deps     installing$missing"
    brew install $missing || exit 1
else
    echo "deps: missing:$missing. Install a C compiler, the GNU Scientific Library with" \
        "headers, Check (libcheck), pkg-config and gnuplot." >&2
    exit 1
fi
echo "  deps     installed:$missing"
