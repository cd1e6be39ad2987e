#!/bin/sh
# mutants.sh lesson NN_slug... - how many small mistakes in the slots of a solution
#                             does its judge find?
# mutants.sh common FILE... - and how many in common/ the unit programs?
#
# Called by tests/mutants.mk with BUILD, the commands CC_MUTANT and LINK, SEED and
# N in the environment.  N mutants (tests/tools/mutants.awk) that compile are
# judged, two at a time; a row of the score is printed, and the survivors go to
# $BUILD/mutants/NAME.txt as differences of one line.  One of which the compiler
# makes the same code is no survivor.  Of the others some are no mistakes either (a
# bound that is never met): read them.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${SEED:=1}"
kind=$1
shift
if [ $kind = common ]; then : "${N:=12}"; else : "${N:=60}"; fi
rm_on_exit=
trap 'rm -rf "$rm_on_exit"' EXIT
trap 'exit 130' INT TERM HUP

# plant FILE LINE TEXT: the file with another text for a line
plant() {
    awk -v at="$2" 'BEGIN { getline text < "/dev/stdin" }
        FNR == at { print text; next } { print }' "$1" <<TEXT
$3
TEXT
}

# found_by DIR: plant's file in DIR compiles (else status 2), and the first thing
# that finds the mistake is printed; nothing if it lives
found_by() {
    if [ $kind = lesson ]; then
        COMPILER=$CC_MUTANT sh tests/tools/program.sh "$1/$name.c" \
            "$name" "$1/judge" 2>/dev/null && $CC_MUTANT "$1/judge.s" -o "$1/judge" \
            "$BUILD/checks/$name.o" $JUDGE $LINK 2>/dev/null || return 2
        "$1/judge" --file mutant --reference "$BUILD/solutions/$name" \
            --result "$1/result" >/dev/null 2>&1
        if [ $? = 2 ]; then echo judge; return; fi
        read -r verdict check slot <"$1/result"
        [ "$verdict" = OK ] || echo "$verdict $check"
        return
    fi
    $CC_MUTANT $native -c "$1/$name.c" -o "$1/mutant.o" 2>/dev/null || return 2
    for unit in $units; do
        $CC_MUTANT "$BUILD/unit/$unit.o" "$1/mutant.o" \
            "$BUILD/unit/unit.o" -o "$1/unit" $LINK 2>/dev/null ||
            { echo "mutants: $unit cannot be linked" >&2; return 2; }
        "$1/unit" >"$1/said" 2>&1 && continue
        sed -n "s/^FAIL \([^:]*: [^:]*\):.*/\1/p" "$1/said" | head -n 1 |
            grep . || echo "$unit"
        return
    done
}

flags='-O1 -fsanitize=address,undefined -fno-sanitize-recover=all'
# sanitized DIR: what lives is run under the sanitizers, as `make test` does it;
# prints the unit program that they end.  Where there are none nothing ends.
sanitized() {
    [ $kind = common ] || return
    (
        ulimit -S -v unlimited # they reserve terabytes,
        ulimit -S -t 60        # and take their time
        $CC_MUTANT $native $flags -c "$1/$name.c" -o "$1/mutant.o" || exit
        for unit in $near; do
            $CC_MUTANT $flags "$BUILD/mutants/unit/$unit.san.o" "$1/mutant.o" \
                "$BUILD/unit/unit.o" -o "$1/unit" $LINK || exit
            ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 "$1/unit" >"$1/said" && continue
            echo "$unit, sanitized"
            exit
        done
    ) 2>/dev/null
}

# half WORKER: every second candidate, until half of N compile; a line of
# "LINE group what-found-it text" (with tabs) each
half() {
    dir=$work/$1
    mkdir -p "$dir"
    # an endless loop is found sooner than by the judge's own limit
    ulimit -S -t 3
    ulimit -S -v 4000000 2>/dev/null
    compiled=0 tried=0
    awk -v half="$1" 'NR % 2 == half' "$work/list" >"$dir/list"
    while IFS='	' read -r at group text; do
        [ $compiled -lt $(((N + 1 - $1) / 2)) ] || break
        tried=$((tried + 1))
        # `read` has dropped the indent, which nobody needs
        plant "$file" "$at" "$text" >"$dir/$name.c"
        found=$(found_by "$dir" </dev/null) || continue
        compiled=$((compiled + 1))
        if [ -z "$found" ] && ! same_code "$dir" 2>/dev/null; then
            found=$(sanitized "$dir" </dev/null)
            : "${found:=lived}"
        fi
        : "${found:=same code}"
        printf '%s\t%s\t%s\t%s\n' "$at" "$group" "$found" "$text"
    done <"$dir/list" >"$work/$1.found"
    echo $tried >"$work/$1.tried"
}

# same_code DIR: the compiler makes the same of it
same_code() {
    mkdir -p "$1/as"
    cp "$file" "$1/as/$name.c"
    $CC_MUTANT $native -O2 -DNDEBUG -c "$1/as/$name.c" -o "$1/a.o" &&
        cp "$1/$name.c" "$1/as/$name.c" &&
        $CC_MUTANT $native -O2 -DNDEBUG -c "$1/as/$name.c" -o "$1/b.o" &&
        cmp -s "$1/a.o" "$1/b.o"
}

# The row and the survivors of $file.
score() {
    name=$(basename "$file" .c)
    work=$BUILD/mutants/$name
    rm -rf "$work" && mkdir -p "$work" || exit 1
    rm_on_exit=$work
    awk -f tests/tools/mutants.awk -v seed="$SEED" "$file" >"$work/list"
    half 0 & first=$!
    half 1 & second=$!
    wait $first $second
    cat "$work/0.found" "$work/1.found" | sort -n >"$BUILD/mutants/$name.found"
    [ -s "$BUILD/mutants/$name.found" ] ||
        { echo "mutants: no mutant of $file compiles" >&2; exit 1; }
    awk -F '\t' -v file="$file" -v name="$name" -v \
        tried="$(($(cat "$work/0.tried") + $(cat "$work/1.tried")))" \
        -v out="$BUILD/mutants/$name.txt" '
        BEGIN { printf "" > out }
        function bare(text) { sub(/^ +/, "", text); return text }
        FILENAME == ARGV[1] { line[FNR] = $0; next }
        {
            compiled++
            equivalent += $3 == "same code"
            killed += $3 != "same code" && $3 != "lived"
            if ($3 != "lived") next
            lived++
            match(line[$1], /^ */)
            indent = substr(line[$1], 1, RLENGTH)
            printf "--- %s\n+++ lived\n@@ -%d +%d @@ %s\n-%s\n+%s\n", file,
                $1, $1, $2, line[$1], indent bare($4) > out
        }
        END {
            real = compiled - equivalent
            printf "  %-26s %6d %8d %10d %6d %5d %6.1f %%\n", name, tried,
                compiled, equivalent, killed, lived,
                (real > 0 ? 100 * killed / real : 100)
            if (lived) print "    those that lived: " out
        }' "$file" "$BUILD/mutants/$name.found"
    rm -rf "$work"
    rm_on_exit=
}

printf '  %-26s %6s %8s %10s %6s %5s %6s\n' '' tried compiled equivalent killed lived score
case $kind in
lesson)
    native=
    for slug; do
        file=solutions/$slug.c
        score
    done ;;
common)
    mkdir -p "$BUILD/mutants/unit"
    for unit in $UNITS; do
        $CC_MUTANT $UNIT_FLAGS $flags -c "tests/unit/$unit.c" \
            -o "$BUILD/mutants/unit/$unit.san.o" 2>/dev/null
    done
    for file; do
        name=$(basename "$file" .c)
        # first the unit programs that look at this file
        units=$(for unit in $UNITS; do
            far=$(awk -v file="$file" -v unit="$unit" -v name="$name" '
                $1 == "file:" { known = $2 == file }
                known && $1 == "caught-by:" && $2 == unit ":" { near += 100 }
                $0 ~ "#include \"(.*/)?" name "[.]h\"" { near += 50 }
                END { print 1000 - near - 500 * (unit == name) }' \
                tests/unit/mistakes.txt "tests/unit/$unit.c")
            echo "$far $unit"
        done | sort -n)
        near=$(echo "$units" | awk '$1 < 1000 { print $2 }')
        units=$(echo "$units" | sed 's/.* //')
        case $name in
        tiles | front | readable) native=$NATIVE ;;
        body | triangles | lanes) native=$NATIVE_BODY ;;
        *) native= ;;
        esac
        native="$native -I${file%/*}" # where a module beside studies has its header
        score
    done ;;
esac
