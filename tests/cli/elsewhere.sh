#!/bin/sh
# elsewhere.sh - the workbook under an older make, with clang, and in a checkout on
# Windows, and a file that an editor there has saved.  OLD_MAKE: the older make;
# "make-3.81", if there is one.  Prints "ok ...", "FAIL ..." or "skip ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}" "${OLD_MAKE:=make-3.81}"
slug=03_dirichlet_correction nn=03
mine=lessons/$slug.c
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok elsewhere: $2"; else echo "FAIL elsewhere: $2: $3"; fi
}
says() { # says STATUS TEXT WHAT COMMAND...
    want=$1 text=$2 what=$3
    shift 3
    said=$("$@" 2>&1 </dev/null)
    [ $? = "$want" ] && printf '%s\n' "$said" | grep -qF -e "$text"
    result $? "$what" "$(printf '%s\n' "$said" | tail -n 20)"
}
copy=$BUILD/test/copy.elsewhere
BUILD="$BUILD" sh tests/tools/copy.sh "$copy" $slug && cp .gitattributes .gitignore "$copy" &&
    cp -p "$BUILD/data/$slug.tsv" "$copy/build" && cd "$copy" || exit 1
mkdir build/data && mv build/$slug.tsv build/data
sed 's/^\( \* PREDICT 1 [^:]*\): .*/\1: 238.5/' solutions/$slug.c >predicted
cp $mine starter

anew() { env MAKELEVEL=0 MAKEFLAGS= "$@"; } # as from a terminal
# ---- an older make -----------------------------------------------------------------
found() { # found TEXT WHAT TOOL FILE: the rule of lint finds it
    awk -f "tests/tools/$3" "$4" | grep -qF -e "$1"
    result $? "lint finds $2" "$(cat "$4")"
}
printf 'list := $(shell grep -c "^#" \\\n   $(wildcard *.c))\n' >a.mk
found 'a.mk:1: #' 'a # in a function' old_make.awk a.mk
printf 'list := $(patsubst %%.c,%%, \\\n   $(shell grep "^\\#"))\n' >a.mk
found 'a.mk:2: #' 'a # in a function of the next line' old_make.awk a.mk
printf 'hash := \\#\nA = $(B) # (what)\na:\n\techo $(shell echo "#")\n' >a.mk
result "$(awk -f tests/tools/old_make.awk a.mk | grep -c .)" 'and no other #' "$(cat a.mk)"
printf 'A = $(eval A := $(B))$(A)\n' >a.mk
found 'A changes itself' 'a variable that changes itself' old_make.awk a.mk
printf 'function part(x) { return x }\nfunction f(a, part) { return a }\n' >a.awk
found 'part of f()' 'a parameter named like a function' parameters.awk a.awk
if command -v "$OLD_MAKE" >/dev/null; then
    old=$("$OLD_MAKE" --version | head -n 1)
    older() { anew "$OLD_MAKE" "$@"; }
    cp predicted $mine
    says 0 'not checked yet' "status, $old" older status
    says 0 'next: make check-03' "lesson-$nn, $old" older -j2 lesson-$nn
    says 0 'OK, all' "check-$nn, $old" older -j2 check-$nn
    says 0 'No cell differs' "diff-$nn, $old" older -j2 diff-$nn
    says 0 'The picture is build/mine/' "plot-$nn, $old" older -j2 plot-$nn
    says 0 'solutions run and judged' "course can be planned, $old" older -n course
    says 0 'count.sh' "test can be planned, $old" older -n test
else
    echo "skip elsewhere: no $OLD_MAKE here, an older make; OLD_MAKE= names one"
fi

# ---- the compiler of a Mac -------------------------------------------------------------
if command -v clang >/dev/null; then
    said=$(anew "$MAKE" CC=clang build/solutions/$slug.judge 2>&1)
    ! echo "$said" | grep -q -e warning -e Error
    result $? 'clang has nothing to say of the solution' "$said"
    cp predicted $mine
    says 0 'OK, all' "check-$nn, CC=clang" anew "$MAKE" CC=clang check-$nn
else
    echo 'skip elsewhere: no clang here'
fi

# ---- a checkout that would end lines as Windows does ---------------------------------
if command -v git >/dev/null; then
    said=$({ git -c init.defaultBranch=main init -q . && git add -A . &&
        git -c core.autocrlf=true checkout-index -a --prefix=checkout/ &&
        cd checkout && find . -type f | sort >../files && xargs cksum <../files >../there &&
        cd .. && xargs cksum <files | diff - there; } 2>&1) && [ "$(wc -l <files)" -gt 1000 ]
    result $? 'git with core.autocrlf=true leaves every file as it is' "$(echo "$said" | tail)"
else
    echo 'skip elsewhere: no git here'
fi

# ---- a file saved there: CRLF, a byte order mark, both --------------------------------
as_saved() { # as_saved HOW FILE
    case $1 in *mark*) printf '\357\273\277' ;; esac
    case $1 in *CRLF*) sed "s/\$/$(printf '\r')/" "$2" ;; *) cat "$2" ;; esac
}
for how in CRLF 'a mark and CRLF'; do
    as_saved "$how" starter >$mine
    says 2 "VERDICT $nn: UNFINISHED (slot 3a)" "the starter with $how" "$MAKE" check-$nn
    says 0 'Hint 1: slot 3a' "its hint, with $how" "$MAKE" hint-$nn
    as_saved "$how" predicted >$mine
    says 0 'next: make check-03' "the solution with $how" "$MAKE" lesson-$nn
    says 0 '1: 238.5, measured' "a prediction with $how" "$MAKE" check-$nn
    says 0 'No cell differs' "diff with $how" "$MAKE" diff-$nn
    says 0 'The picture is build/mine/' "plot with $how" "$MAKE" plot-$nn
    sed 's/b\[i\] -= A\[/b[i] += A[/' predicted >wrong
    as_saved "$how" wrong >$mine
    says 2 'known_values_move_to_the_right (slot 3a)' "a mistake with $how" "$MAKE" check-$nn
    { printf '/* mine */\n#include "../solutions/%s.c"\n' $slug; } >wrong
    as_saved "$how" wrong >$mine
    says 2 "VERDICT $nn: WRONG (refused)" "what is refused with $how" "$MAKE" check-$nn
done
cd - >/dev/null && rm -rf "$copy"
