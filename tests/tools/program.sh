#!/bin/sh
# program.sh PROGRAM NN_slug INTO - a program compiled alone, as its checks call it:
# INTO.s is its assembler text (assembler.awk), INTO.o the checks where they must be
# compiled anew, because a struct of the program has other members.
#
# A program may use any name, and define any macro.  It is preprocessed, which ends
# its macros, and what the checks call is set behind it (program.awk).  It is
# refused, with a line "refused: WHY", where it runs before its main() or includes
# another program.  COMPILER has its flags.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
program=$1 into=$3
checks=$BUILD/checks/$2 part=$into.$$
trap 'rm -f "$part" "$part".[ihs]' EXIT
trap 'exit 130' HUP INT TERM

# An #include or a macro may multiply without end, in time, text or memory.
{
    printf '#include "%s"\nprogram_has' "$program"
    while read -r name rest; do printf ' %s' "$name"; done <"$checks.calls"
    echo
} >"$part.i"
({ ulimit -t 4; ulimit -f 8192; ulimit -v 1000000; } 2>/dev/null
    exec $COMPILER -w -E -MD -MP -MF "$into.d" -MT "$into" - \
        <"$part.i" >"$part" 2>"$part.s")
status=$?
if [ $status != 0 ]; then
    if [ $status -gt 127 ] || [ "$(wc -c <"$part")" -ge 4000000 ] ||
        grep -qi -e signal -e 'out of memory' -e 'bad_alloc' "$part.s"; then
        echo 'refused: what it includes, or its macros, have no end' >&2
    else
        cat "$part.s" >&2
    fi
    exit 1
fi
[ ! -f "$into.o" ] || rm -f "$into.o"
awk -v program="$program" -v into="$part.h" -f tests/tools/program.awk "$checks.h" \
    "$checks.calls" "$part" >"$part.i" || exit 1
[ ! -f "$part.h" ] || $COMPILER -w -I. -Itests/checks -DPROGRAM="\"$part.h\"" -c \
    "tests/checks/$2.c" -o "$into.o" || {
    echo 'refused: a struct of the starter has a member of a type of its own' >&2
    exit 1
}
# what is preprocessed has no use for -I, of which clang would warn
$(echo "$COMPILER" | sed 's/ -I[^ ]*//g') -S -fno-common -fno-lto -x cpp-output \
    "$part.i" -o "$part.s" &&
    awk -v sanitized="${SANITIZED:-}" -f tests/tools/assembler.awk \
        "$checks.words" "$checks.calls" "$part.s" >"$part" &&
    mv -f "$part" "$into.s"
