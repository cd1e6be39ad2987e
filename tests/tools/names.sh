#!/bin/sh
# names.sh PROGRAM NN_slug INTO - the header around a program, before its checks.
#
# A program may use any name, and define any macro.  Before it (program.h, where
# `main` is a macro) the header INTO
#   - gives names of its own to what the program alone defines, so that neither
#     the checks nor the system have them too: close() may be anything.
# Behind it, it
#   - ends these again, and each macro of the program's, or brings back what the
#     system means by it; one stays: that by which alone there is a function of
#     the lesson;
#   - gives what is declared by the checks names that no program has.
# A program is refused, with a line "refused: WHY", that runs before its main()
# or includes another program.  CPP is the compiler with its flags.
set -u
LC_ALL=C
export LC_ALL
program=$1 slug=$2 into=$3
check=tests/checks/$slug.c solution=solutions/$slug.c
part=$into.$$
trap 'rm -f "$part" "$part.i" "$part.e" "$part.s"' EXIT
trap 'exit 130' HUP INT TERM

refuse() { # refuse WHY...
    echo "refused: $*" >&2
    exit 1
}

# An #include or a macro may multiply without end, in time, text or memory.
({ ulimit -t 4; ulimit -f 8192; ulimit -v 1000000; } 2>/dev/null
    $CPP -w -E "$program" >"$part.i" 2>"$part.e") ||
    { [ $? -lt 128 ] && [ "$(wc -c <"$part.i")" -lt 4000000 ] &&
        ! grep -qi -e signal -e 'out of memory' -e 'bad_alloc' "$part.e"; } ||
    refuse 'what it includes, or its macros, have no end'

header() { # header [FILE]: with the system's macros
    PROGRAM=$program SYSTEM=${1:-} awk -f tests/tools/names.awk \
        -f tests/tools/own.awk -v slug="$slug" <"$part.i" >"$part"
}
header
status=$?
if [ $status = 3 ]; then # what the system means by the program's macros
    { cat "$solution" && grep '^#include <' "$check"; } |
        $CPP -w -E -dM -x c - >"$part.s" || exit 1
    header "$part.s"
    status=$?
fi
[ $status = 0 ] && mv -f "$part" "$into"
