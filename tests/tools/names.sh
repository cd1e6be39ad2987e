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
LC_ALL=C
export LC_ALL
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
# The lines that are in the first list, but not in the second.
without() { printf '%s\n' "$1" "$2" "$2" | sort | uniq -u; }
# The words of PROGRAM itself when its macros are replaced.
words() {
    $CPP -w -E "$program" 2>/dev/null | awk -v program="\"$program\"" '
            /^#/ { own = index($0, program); next } own' | sed 's/"[^"]*"//g' |
        tr -cs 'A-Za-z_0-9' '\n' | sort -u
}
mine=$(without "$(macros "$program")" "$(macros "$solution")")
{
    if [ -n "$mine" ]; then
        system=$({ cat "$solution" && grep '^#include <' "$check"; } |
            $CPP -w -E -dM -x c -) || exit 1
        ours=$(awk -f tests/tools/names.awk "$solution" | sed 's/.* //' | sort -u)
        kept=$(printf '%s\n' "$mine" "$ours" | sort | uniq -d)
        [ -z "$kept" ] || kept=$(without "$kept" "$(words)" | tr '\n' ' ')
        { echo "$mine"; echo "$system"; } | awk -v kept=" $kept " '
            !/^#/ && !index(kept, " " $1 " ") { print "#undef " $1; ended[$1] }
            /^#/ { name = $2; sub(/\(.*/, "", name); if (name in ended) print }'
    fi
    awk -f tests/tools/names.awk -v slug="$slug" "$check"
} >"$part" && mv -f "$part" "$into"
