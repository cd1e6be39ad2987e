#!/bin/sh
# diff.sh - `make diff-03` and `make plot-03`, and the options ARGS, in a copy
# whose path has a space and an apostrophe.  Prints "ok ...", "FAIL ..." or
# "skip ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
slug=03_dirichlet_correction
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok diff: $2"; else echo "FAIL diff: $2: $3"; fi
}
copy="$BUILD/test/it's a copy"
BUILD="$BUILD" sh tests/tools/copy.sh "$copy" $slug || exit 1
specs=$(for f in solutions/[0-9]*.c; do
    echo "$(basename "$f" .c) $(sed -n 's/^ \* Plot: *//p' "$f")"; done)
for s in $(echo "$specs" | cut -d ' ' -f 1); do
    cp "$BUILD/solutions/$s.judge" "$copy/build/solutions/"
    cp "$BUILD/data/$s.tsv" "$copy/build/$s.tsv"
done
cd "$copy" || exit 1
mkdir -p build/data build/mine shells
next() { first=${ring%% *} ring="${ring#* }$first "; } # $first goes to the end of $ring
goal() { # goal GOAL [VARIABLE=...]: as from a terminal; $said, $status, $shell
    next
    shell=$first
    said=$(MAKELEVEL=0 MAKEFLAGS= PATH=$PWD/shells/$shell:$PATH "$MAKE" "$@" 2>&1)
    status=$?
}
says() { # says STATUS WHAT TEXT...: each TEXT is said, and the status is this
    want=$1 what="$2, in $shell" why=
    shift 2
    [ $status = "$want" ] || why="status $status; "
    for text in "$@"; do
        echo "$said" | tr -s ' ' | grep -qF -e "$text" || why="$why no '$text'; "
    done
    [ -z "$why" ]
    result $? "$what" "$why$said"
}
# mine EDIT: the solution with a line changed by sed
mine() {
    { printf '#include <signal.h>\n#include <stdio.h>\n'
        sed "$1" solutions/$slug.c; } >lessons/$slug.c
    sed 1,2d lessons/$slug.c | cmp -s - solutions/$slug.c && [ -n "$1" ] &&
        result 1 "the edit $1" 'it changes nothing'
}

# ---- whole programs, each goal in another shell ------------------------------
for shell in dash bash 'busybox sh'; do
    program=$(command -v "${shell%% *}") || { echo "skip diff: no $shell here"; continue; }
    at=shells/${shell%% *}
    mkdir "$at" && printf '#!/bin/sh\nexec %s "$@"\n' "$program${shell#"${shell%% *}"}" \
        >"$at/sh" && chmod +x "$at/sh"
done
ring=$(ls shells | tr '\n' ' ')
mine ''
goal diff-03
says 0 'a right program' 'nodes none of 21 cells differ' \
    'No cell differs by more than the check allows.' \
    'make check-03 tries other options and calls each function, too.'
goal diff-03 ARGS='--n 2 --fix both'
says 0 'with options' 'nodes none of 9 cells differ' 'No cell differs'
! cmp -s build/data/$slug.tsv build/mine/$slug.reference.tsv
result $? "the default run's data stay, in $shell" 'they have gone'
goal diff-03 ARGS='--n 1'
says 2 'options that are refused' "the reference: 03_dirichlet_correction: --n 1: must be"
goal plot-03
says 0 'a picture of a right program' reference 'what the check allows' mine \
    'Table `nodes`, `u` over `x`'
grep -q '</svg>' build/mine/$slug.svg
result $? "an SVG is drawn, in $shell" "$(ls build/mine)"
goal lesson-03 ARGS='--n 2 --fix both' TABLE=nodes
says 0 'a lesson with options' '0.5 0.397396'
for ask in lesson diff plot; do
    goal $ask-03 ARGS=-h
    says 0 "$ask lists the options" '--fix prescribed nodes'
done
for bad in '$(touch pwned)' '`touch pwned`' '; touch pwned' "'; touch pwned '" \
    '$(shell touch pwned)' '*'; do
    goal lesson-03 ARGS="$bad" TABLE="$bad"
    [ ! -f pwned ] && echo "$said" | grep -qF "'${bad%% *}' is not an option"
    result $? "options are split at blanks and no more: $bad, in $shell" "$said"
done

mine 's|    /\* END 3b \*/|    printf("now\\n");&|
      s|table_row((double)i / (N - 1), u\[i\], r|table_row((double)i / (N - 1), u[i] + 1e-3 * (i == 2), r|'
goal diff-03
says 0 'a wrong program' 'nodes 1 of 21 cells differ, worst:' \
    'nodes 3 (x = 0.333333) u 0.0615929 0.0605929' '1 line on stdout' \
    'TABLE=nodes shows all of that table.'
goal diff-03 TABLE=nodes
says 0 'one table' '3 (x = 0.333333) u 0.0615929 0.0605929'
goal diff-03 TABLE=nowhere
says 2 'no such table' 'There is no table `nowhere`; there are: A, b, A_corrected'
goal lesson-03
says 0 'a stray line' 'Lines on stdout that belong to no table:' ' now'
goal plot-03 TABLE=b
says 0 'a picture of what is right' \
    'Off by more than the check allows: `u` of `nodes`' \
    'make plot-03 Y=u draws the worst of them.'
goal plot-03 TABLE=b ARGS='--n 3'
says 0 'the same, with options' "make plot-03 Y=u ARGS='--n 3' draws the worst of them."
goal plot-03 Y=nothing
says 2 'no such column' 'Table `nodes` has no column `nothing`; it has: x, u, reaction'
goal plot-03 TABLE=A KEY=i X=j Y=value
says 0 'a curve for each key' 'mine: i = 6' 'a curve for each `i`'
goal check-03 ARGS=-h
says 2 'ARGS for a goal that takes none' 'make check-03 ignores ARGS'
goal diff-03 X=x
says 2 'X for a goal that takes none' 'make diff-03 ignores X'

mine 's|^    table_vector("b", N, b);|    exit(1);|'
goal diff-03
says 0 'status 1' 'Yours ends with status 1: it is compared until then.' \
    'A none of 147 cells differ' 'nodes your program prints no such table'
goal plot-03
says 2 'nothing of mine to draw' 'Nothing of yours is there to draw' reference
goal plot-03 TABLE=A
says 0 'a picture of what there is' 'ends with status 1' 'Table `A`'
mine 's|^    table_vector("b", N, b);|    b[1] += 1.0;&exit(1);|'
goal plot-03
says 0 'what is worst, where the lesson has no picture of mine' \
    'Of table `nodes` yours has nothing; what is worst is drawn.' \
    'Table `b`, `value` over `i`'
mine 's|table_row((double)i / (N - 1), u\[i\], r|table_row((double)i / (N - 1), u[i] * (i == 2 ? 1e300 : 1), r|'
goal plot-03
says 0 'what leaves the picture' 'Yours leaves the picture: it goes from'
! grep -q '>29[0-9]<' build/mine/$slug.svg # 10^298 at a tic
result $? "and the reference is seen, in $shell" "$(grep '^top' build/mine/$slug.curves.gp)"
mine 's|^    table_vector("b", N, b);|    fflush(stdout); raise(6);|'
goal diff-03
says 0 'a crash' 'Yours ends with status 134 (signal ABRT)' 'A none of 147 cells differ'
mine 's|    /\* SLOT 3c|    todo("3c", N);&|'
goal diff-03
says 0 'a slot that is not written' 'Yours is unfinished' 'unfinished: slot 3c' \
    'b_corrected'

# ---- what the verdict says next ----------------------------------------------
mine 's|table_row((double)i / (N - 1), u\[i\], r|table_row((double)i / (N - 1), u[i] + (N == 12), r|'
goal check-03
says 2 'the verdict leads to the comparison' \
    "next: make diff-03 ARGS='--n 11 --fix right --right -0.613 --beta 2.385', make hint-03"
options=$(echo "$said" | sed -n "s/.*ARGS='\(.*\)'.*/\1/p")
goal diff-03 ARGS="$options"
says 0 'and the comparison shows what is wrong' 'nodes 12 of 36 cells differ'

mine 's|b\[i\] -= A|b[i] -= (n_fixed == 1 ? 2.0 : 1.0) * A|'
goal check-03
says 2 'nor is it passed over where another check comes first' \
    "next: make hint-03, make diff-03 ARGS='--n 7 --fix left --left 2.385 --f -3.714'"
mine 's|    /\* END 3b \*/|    printf("now\\n");&|'
goal check-03
says 2 'a stray line is shown by the lesson' 'a line that belongs to no table: `now`' \
    'next: make lesson-03'

# ---- outputs, with each awk ---------------------------------------------------
compared() { # compared EDIT: the reference's output, changed by an awk program
    "$awk" -F '\t' -v OFS='\t' -v CONVFMT=%.17g "/^#/ { t = \$2 = substr(\$0, 3); \$2 = \"\"; \$0 = \"# \" t; r = -1 }
        { r++ } $1" build/$slug.tsv >mine.tsv
    build/solutions/$slug.judge --cells mine.tsv build/$slug.tsv >cells
    said=$("$awk" -v nn=03 -v only="${2:-}" -f tests/tools/diff.awk cells 2>&1)
    status=$?
}
mkdir -p awks
for shell in mawk gawk 'gawk --posix' original-awk 'busybox awk'; do
    program=$(command -v "${shell%% *}") || { echo "skip diff: no $shell here"; continue; }
    awk=awks/$(echo "$shell" | tr -d ' ')
    printf '#!/bin/sh\nexec %s "$@"\n' "$program${shell#"${shell%% *}"}" >"$awk"
    chmod +x "$awk"
    compared '{ print }'
    says 0 'nothing differs' 'No cell differs'
    compared 't != "b" || r != 4 { print }'
    says 0 'a row is missing' 'b none of 12 cells differ; rows: mine 6, reference 7' \
        'rows that yours does not have:' 'row 3 (i = 2)'
    compared 't != "b" || r < 4 || !NF { print }'
    says 0 'many rows are missing' 'rows that yours does not have: 3 (i = 2) to 7 (i = 6)'
    compared 't == "nodes" && r == 3 { $2 = "1e303" } { print }'
    says 0 'a number far off' '1e+303 0.152007 over 1e300 times'
    compared '{ print } t == "b" && r == 4 { print "2.5\t7" }'
    says 0 'a row too many' 'rows: mine 8, reference 7' \
        'rows that the reference does not have:' 'row 4 (i = 2.5)'
    compared 't == "nodes" && NF > 1 { $4 = r == 1 ? "more" : r } { print }'
    says 0 'a column too many' 'columns that the reference does not have: `more`' \
        'No cell differs'
    compared 't == "nodes" && NF > 1 { $0 = $1 OFS $2 } { print }'
    says 0 'a column is missing' 'missing columns: `reaction`'
    compared 't == "nodes" && r == 3 { $2 = "STALLED" } { print }'
    says 0 'a word for a number' 'u STALLED 0.152007 a word for a number'
    compared 't == "nodes" && r == 3 { $2 = "nan" } { print }'
    says 0 'a NaN' 'u nan 0.152007 not finite'
    compared 't == "nodes" && r == 3 { $2 *= 1 + 2e-8 } t == "nodes" && r == 2 { $2 *= 1 + 1e-10 } t == "nodes" && r == 8 { printf "%s", $0; exit } { print }'
    says 0 'a last line that is cut off, and a cell off by 6 times what is allowed' \
        'nodes 1 of 18 cells differ' '5.94 times' 'row 7 (x = 1)' \
        '1 line on stdout'
    compared '{ print } /^$/ && !n++ { print "hello\n\n# own\na\tb\n1\t2\n\n" }'
    says 0 'a stray line and a table of my own' \
        'own the reference prints no such table' '1 line on stdout' 'No cell differs'
    compared 'BEGIN { while (k++ < 3000) print "x" } { print }'
    says 0 'many stray lines' '1000 or more lines' 'No cell differs'
    s=12_triangles
    build/solutions/$s.judge --cells build/$s.tsv build/$s.tsv >cells
    for axes in 'residual,k residual logy,1' 'residual,k residual,0' \
        'increment,k residual,1' 'k,k residual logy,0'; do
        rest=${axes#*,}
        said=$(SPEC="history ${rest%,*}" TABLE= X= Y="${axes%%,*}" KEY= curves=curves \
            "$awk" -f tests/tools/plot.awk cells)
        echo "$said" | grep -qx "log_y = ${rest#*,}"
        result $? "a log axis or none: $axes, $shell" "$said"
    done
done
# ---- each lesson's tables, with another awk -------------------------------------
ring=$(ls awks | tr '\n' ' ')
for s in $(echo "$specs" | cut -d ' ' -f 1); do
    next
    awk=awks/$first shell=$first
    build/solutions/"$s".judge --cells "build/$s.tsv" "build/$s.tsv" >cells
    said=$("$awk" -v nn=03 -f tests/tools/diff.awk cells | grep -v 'none of')
    [ "$said" = 'No cell differs by more than the check allows.
make check-03 tries other options and calls each function, too.' ]
    result $? "the reference beside itself, $s, $shell" "$said"
    said=$(SPEC=$(echo "$specs" | sed -n "s/^$s //p") TABLE= X= Y= KEY= \
        curves=curves "$awk" -f tests/tools/plot.awk cells)
    [ $? = 0 ] && echo "$said" | grep -q '^points = [1-9]' && [ -s curves ] &&
        ! echo "$said" | grep -q 'does not compare'
    result $? "what the head of $s says to plot is there, $shell" "$said"
done
cd - >/dev/null && rm -rf "$copy"
