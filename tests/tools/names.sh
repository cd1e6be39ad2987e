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
# or includes a solution.  CPP is the compiler with its flags.
set -u
LC_ALL=C
export LC_ALL
program=$1 slug=$2 into=$3
check=tests/checks/$slug.c solution=solutions/$slug.c
part=$into.$$
trap 'rm -f "$part" "$part.i" "$part.e"' EXIT
trap 'exit 130' HUP INT TERM

# The names that the program defines or undefines as macros: "both NAME" if the
# solution does so, too, "mine NAME" if not.
macros() {
    awk 'sub(/^[ \t\r\f\v]*#[ \t\r\f\v]*(define|undef)[ \t\r\f\v]+/, "") &&
        match($0, /^[A-Za-z_][A-Za-z_0-9]*/) {
            name = substr($0, 1, RLENGTH)
            if (FILENAME == ARGV[1]) solution[name]
            kind = name in solution ? "both" : "mine"
            if (FILENAME == ARGV[2] && !said[name]++) print kind, name
        }' "$solution" "$program"
}
# The lines that are in the first list, but not in the second.
without() { printf '%s\n' "$1" "$2" "$2" | sort | uniq -u; }
refuse() { # refuse WHY...
    echo "refused: $*" >&2
    exit 1
}
# own KIND: those names that the program has of its own, one on each line.
own() { printf '%s\n' "$all" | sed -n "s/^$1 //p"; }

# An #include or a macro may multiply without end, in time, text or memory.
({ ulimit -t 4; ulimit -f 8192; ulimit -v 1000000; } 2>/dev/null
    $CPP -w -E "$program" >"$part.i" 2>"$part.e") ||
    { [ $? -lt 128 ] && [ "$(wc -c <"$part.i")" -lt 4000000 ] &&
        ! grep -qi -e signal -e 'out of memory' -e 'bad_alloc' "$part.e"; } ||
    refuse 'what it includes, or its macros, have no end'
all=$(awk -f tests/tools/own.awk "$part.i")
case $all in refused*) refuse "$(own refused | head -n 1)" ;; esac
macros=$(macros)
mine=$(echo "$macros" | sed -n 's/^mine //p')
macros=$(echo "$macros" | sed 's/.* //')
ours=$(awk -f tests/tools/names.awk "$solution" | sed 's/.* //')
kept=
[ -z "$mine" ] || kept=$({ echo "$mine" && echo "$ours" | sort -u; } |
    sort | uniq -d)
[ -z "$kept" ] || kept=$(without "$kept" "$(own word)")
# what such a macro stands for keeps its name
theirs=$(echo $ours $macros; for name in $kept; do
    sed -n "s/^[[:space:]]*#[[:space:]]*define[[:space:]]*$name//p" "$program" |
        tr -cs 'A-Za-z_0-9' ' '; done)
{
    echo '#ifdef main'
    printf '%s\n' "$all" | awk -v theirs="$(echo $theirs)" '
        BEGIN { n = split(theirs, name, " "); while (n) kept[name[n--]] }
        $2 in kept { next }
        $1 == "own" { print "#define " $2 " program_own_" $2; own[$2] }
        $1 == "linked" { print "#pragma redefine_extname", $2, "program_own_" $2 }
        END { print "#else"; for (k in own) print "#undef " k }'
    if [ -n "$mine" ]; then
        system=$({ cat "$solution" && grep '^#include <' "$check"; } |
            $CPP -w -E -dM -x c -) || exit 1
        { echo "$mine"; echo "$system"; } | awk -v kept=" $(echo $kept) " '
            !/^#/ && !index(kept, " " $1 " ") { print "#undef " $1; ended[$1] }
            /^#/ { name = $2; sub(/\(.*/, "", name); if (name in ended) print }'
    fi
    awk -f tests/tools/names.awk -v slug="$slug" "$check"
    echo '#endif'
} >"$part" && mv -f "$part" "$into"
