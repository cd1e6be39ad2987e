#!/bin/sh
# names.sh PROGRAM NN_slug INTO - the header between a program and its checks.
#
# A program may use any name, and define any macro.  Behind it (program.h) the
# header INTO
#   - ends each macro of its own, or brings back what the system means by it;
#     one stays: that by which alone there is a function of the lesson;
#   - gives what is declared by the checks names that no program has.
# CPP is the compiler with its flags.
set -u
program=$1 slug=$2 into=$3
check=tests/checks/$slug.c solution=solutions/$slug.c
part=$into.$$
trap 'rm -f "$part"' EXIT
trap 'exit 130' HUP INT TERM

# The names that FILE defines or undefines as macros.
macros() {
    sed -n 's/^[[:space:]]*#[[:space:]]*define[[:space:]]/#/p
            s/^[[:space:]]*#[[:space:]]*undef[[:space:]]/#/p' "$1" |
        sed -n 's/^#[[:space:]]*\([A-Za-z_][A-Za-z_0-9]*\).*/\1/p' | sort -u
}
# Whether there is a function FUNCTION when the macros of PROGRAM are replaced.
is_there() {
    [ -n "${plain:-}" ] || plain=$($CPP -w -E "$program" 2>/dev/null)
    echo "$plain" | grep -Eq "(^|[^A-Za-z_0-9])$1[[:space:]]*\\("
}
mine=$({ macros "$program"; macros "$solution"; macros "$solution"; } |
    sort | uniq -u)
{
    if [ -n "$mine" ]; then
        system=$($CPP -w -E -dM -DPROGRAM="\"$solution\"" -DNAMES='"status.h"' \
            "$check") || exit 1
        ours=$(awk -f tests/tools/names.awk "$solution" | sed 's/.* //')
        for name in $mine; do
            if echo "$ours" | grep -qx "$name" && ! is_there "$name"; then
                continue
            fi
            echo "#undef $name"
            echo "$system" | grep -E "^#define $name([^A-Za-z_0-9]|\$)"
        done
    fi
    awk -f tests/tools/names.awk -v slug="$slug" "$check"
} >"$part" && mv -f "$part" "$into"
