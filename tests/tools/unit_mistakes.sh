#!/bin/sh
# unit_mistakes.sh FILE DIR - is each deliberate mistake in FILE of common/, of those
# in tests/unit/mistakes.txt, caught by its law?
#
# FILE with all of them is compiled once, into DIR, and linked before the library
# with the unit programs that have their laws; the environment says which it is
# (variant.awk).  One that is in no function is compiled alone.  COMPILE and LIBS are
# the compiler's words.  Prints ok and FAIL lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
file=$1 dir=$2
rm -rf "$dir" && mkdir -p "$dir" || exit 1
variant() { awk -f tests/tools/variant.awk "$@" tests/unit/mistakes.txt "$file"; }
build() { # build NAME UNIT: $dir/NAME.UNIT of NAME.c
    [ -f "$dir/$1.o" ] || $COMPILE -c "$dir/$1.c" -o "$dir/$1.o" &&
        $COMPILE "$dir/$1.o" "$BUILD/unit/$2.o" "$BUILD/unit/unit.o" \
            -o "$dir/$1.$2" $LIBS
}
variant -v all="$dir" -v file="$file" >"$dir/list"
while read -r number kind name unit law; do
    of=all
    if [ "$number" = alone ]; then
        of=$name
        variant -v name="$name" >"$dir/$name.c"
    fi
    [ -x "$dir/$of.$unit" ] || build $of "$unit" >"$dir/said" 2>&1
    # one that does not end is ended
    said=$(ulimit -t 60
        MISTAKE=$number exec "$dir/$of.$unit" "$law" 2>&1)
    case "
$said" in
    *"
FAIL $unit: $law:"*) echo "ok common/ with $name is caught" ;;
    *) echo "FAIL common/ with $name is not caught: $(cat "$dir/said") $said" ;;
    esac
done <"$dir/list"
