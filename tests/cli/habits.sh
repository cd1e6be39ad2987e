#!/bin/sh
# habits.sh - what a student tries besides `make check-03`: other flags, debug,
# hints, what comes next, goals mistyped, tools that are missing, one figure, the
# window.  In a path with a space and an apostrophe, and what student.sh does
# under each shell.  Prints "ok ...", "FAIL ..." or "skip ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
slug=03_dirichlet_correction nn=03
mine=lessons/$slug.c
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok cli: $2"; else echo "FAIL cli: $2: $3"; fi
}
. tests/tools/patiently.sh
within=$(within 1800)
says() { # says TEXT WHAT COMMAND...: TEXT is a pattern in what it says
    text=$1 what=$2
    shift 2
    said=$($within "$@" 2>&1 </dev/null)
    echo "$said" | grep -q -e "$text"
    result $? "$what" "$(echo "$said" | tail -n 20)"
}

# ---- editors ------------------------------------------------------------------
if command -v clangd >/dev/null; then
    for file in tests/checks/$slug.c common/motion/view_sdl.c; do
        says '[^0-9]0 errors' "clangd finds no error in $file" \
            clangd --check=$file
    done
else
    echo 'skip cli: no clangd here'
fi

copy="$BUILD/test/a pupil's copy"
BUILD="$BUILD" sh tests/tools/copy.sh "$copy" $slug || exit 1
cd "$copy" || exit 1

# ---- flags ---------------------------------------------------------------------
compiles() { # compiles yes|no WHAT GOAL WORDS...: objects of common/
    want=$1 what=$2
    shift 2
    touch mark && sleep 1
    said=$("$MAKE" "$@" 2>&1)
    found=no
    [ -z "$(find build/common -name '*.o' -newer mark)" ] || found=yes
    [ $found = $want ]
    result $? "$what" "$found: $(echo "$said" | tail -n 5)"
}
cp solutions/$slug.c $mine
cp -Rp build built
(
# without the flags for this machine and without -O2, which take the compiler long
compiles no 'what the same flags have made stays' lesson-$nn
compiles yes 'other flags compile anew' lesson-$nn CFLAGS='-O0 -g0' NATIVE=
compiles no 'the same other flags do not' lesson-$nn CFLAGS='-O0 -g0' NATIVE=
compiles yes 'another NATIVE compiles anew' lesson-$nn CFLAGS='-O0 -g0' NATIVE=-O0
NATIVE=
export NATIVE
compiles yes 'another CC compiles anew' lesson-$nn CFLAGS='-O0 -g0' CC='cc -g'
for k in 1 2; do
    "$MAKE" lesson-$nn CFLAGS=-O0 >said.$k 2>&1 &
    eval "run$k=\$!"
done
wait "$run1" && wait "$run2" && [ -z "$(find build -name '*.part')" ] &&
    grep -q -e ' -O0 NATIVE=' build/flags
result $? 'two makes at once take to other flags' "$(cat said.1 said.2)"
compiles yes 'a verdict has the flags that it is asked for' check-$nn CFLAGS=-g0
compiles no 'and once is enough' check-$nn CFLAGS=-g0
[ -z "$("$MAKE" -n lesson-$nn CFLAGS=-g0 | grep -e ' -c ')" ] &&
    "$MAKE" -n lesson-$nn CFLAGS=-O0 | grep -q ' -c ' &&
    grep -q -e ' -g0 NATIVE=' build/flags
result $? 'make -n says what would be compiled, and changes nothing' \
    "$("$MAKE" -n lesson-$nn CFLAGS=-g0; cat build/flags)"
)
rm -rf build && mv built build

# ---- what student.sh does, under each shell --------------------------------------
with_line() { # with_line LINE: the solution with LINE in its first slot
    line=$1 awk '{ print }
        !done && /\/\* SLOT / { inside = 1 }
        inside && /\*\// { print ENVIRON["line"]; inside = 0; done = 1 }' \
        solutions/$slug.c >$mine
    at=$(grep -n -F -e "$1" $mine | head -n 1)
    at=$mine:${at%%:*}
}
twice='char *volatile p = malloc(8); free(p); p[0] = 1;'
can=$(echo 'int main(void) { return 0; }' >try.c
    ${CC:-cc} -fsanitize=address,undefined try.c -o try 2>&1 && ./try 2>&1)
# Each command under another shell: sh itself, dash on Debian, runs all other tests.
path=$PATH ring=
for shell in bash 'busybox sh'; do
    program=$(command -v "${shell%% *}") || {
        echo "skip cli: no $shell here"
        continue
    }
    at=${shell%% *} ring="$ring${shell%% *} "
    mkdir -p "$at" && printf '#!/bin/sh\nexec %s "$@"\n' \
        "$program${shell#"${shell%% *}"}" >"$at/sh" && chmod +x "$at/sh"
done
next() {
    first=${ring%% *} ring="${ring#* }$first "
    PATH=$PWD/$first:$path
}
rm -f build/progress/*
if [ -z "$can" ]; then
    with_line "$twice"
    next
    says "in move_known_values, $at\$" "debug names the line of a use after free, $first" \
        "$MAKE" debug-$nn
    with_line 'double q[3]; for (volatile int k = 0; k <= 3; k++) q[k] = k;'
    next
    says "in move_known_values, $at\$" "debug names the line of an index, $first" \
        "$MAKE" debug-$nn
    with_line ''
    next
    says 'ends well; the sanitizers .* found nothing' \
        "debug says that a program is fine, $first" "$MAKE" debug-$nn
    awk -f tests/tools/starter.awk solutions/$slug.c >$mine
    next
    says 'comes to a slot that is not written' "debug of a starter, $first" \
        "$MAKE" debug-$nn
else
    echo 'skip cli: no sanitizers here'
fi
cp solutions/$slug.c $mine
next
says 'next: lesson 08, Element by element, .*(lessons/08_element' \
    "a pass says what is next, $first" "$MAKE" check-$nn
next
"$MAKE" hint-$nn >said 2>&1
[ "$(grep -c 'hint-03 SLOT=3[abc]$' said)" = 3 ] && ! grep -q '^Hint' said
result $? "without a slot no hint is shown, $first" "$(cat said)"
next
says '^Hint 1: slot 3b' "a hint for the slot that is asked for, $first" \
    "$MAKE" hint-$nn SLOT=3b
with_line 'exit(0);'
next
"$MAKE" check-$nn >/dev/null 2>&1
"$MAKE" hint-$nn >/dev/null 2>&1
next
says '^(hint 2 of 3' "the level of hints rises, $first" "$MAKE" hint-$nn
echo '/* edited */' >>$mine
next
says '^(hint 1 of 3' "an edit takes it back, $first" "$MAKE" hint-$nn
rm $mine && mkfifo $mine
next
says 'is not a plain file' "a pipe in the place of the file, $first" \
    "$MAKE" lesson-$nn
rm $mine && cp solutions/$slug.c $mine
PATH=$path

# ---- goals ----------------------------------------------------------------------
for pair in check-7:check-07 chek-07:check-07 lesson7:lesson-07 plot-007:07 \
    watch:watch-07 hint-3x:hint-03 stauts:'make status' zork:'make alone'; do
    says "${pair#*:}" "make ${pair%%:*} says ${pair#*:}" "$MAKE" "${pair%%:*}"
done
for goals in chek-07 watch zork 'check-7 help'; do
    "$MAKE" $goals >/dev/null 2>&1
    [ $? = 2 ]
    result $? "make $goals fails" 'status 0'
done
mv $mine moved
for goal in lesson plot; do
    says "^$mine is not there.*make reset-$nn" \
        "without my file $goal does not run the program of before" \
        "$MAKE" $goal-$nn
done
mv moved $mine
mv tests/checks/cells.c moved && rm build/tests/checks/cells.o build/solutions/$slug.judge
says 'No rule to make target .*cells.c.*needed by .*cells.o' \
    'a file that is missing is named, and by whom it is needed' \
    "$MAKE" plot-$nn
mv moved tests/checks/cells.c

# ---- what is missing ----------------------------------------------------------------
mkdir tools hide hide/gsl
echo "$PATH" | tr : '\n' | while IFS= read -r folder; do
    ln -s "$folder"/* tools 2>/dev/null # what is there already stays
done
cc=${CC:-cc}
rm -f tools/gnuplot tools/gsl-config "tools/${cc##*/}"
for header in math errno linalg; do
    echo '#error not here' >hide/gsl/gsl_$header.h
done
# the compiler may be ccache, which looks for another one
printf '#!/bin/sh\nPATH="%s"; exec %s -Ihide "$@"\n' "$PATH" "$cc" >tools/nogsl
sed 's/ -Ihide//' tools/nogsl >"tools/${cc##*/}"
chmod +x tools/nogsl "tools/${cc##*/}"
cp -p build/flags flags.before
for goal in lesson plot check; do
    said=$(PATH=$PWD/tools "$MAKE" $goal-$nn CC=nogsl 2>&1)
    [ $? = 2 ] && echo "$said" | grep -q 'GSL.*make deps'
    result $? "$goal without GSL says make deps" "$said"
done
mv flags.before build/flags # the library need not be compiled once more
"$MAKE" lesson-$nn >/dev/null 2>&1
said=$(PATH=$PWD/tools "$MAKE" plot-$nn 2>&1)
[ $? = 2 ] && echo "$said" | grep -q 'gnuplot.*make deps'
result $? 'plot without gnuplot says make deps' "$said"
rm -rf tools

# ---- one figure ------------------------------------------------------------------
says 'figures/03_dirichlet_correction/conditioning.svg$' 'one figure is drawn' \
    "$MAKE" figure-03-conditioning
says '^  conditioning$' 'a figure that there is not' \
    "$MAKE" figure-03-zork
says 'left to make bench' 'make figures says what it leaves out' \
    "$MAKE" -n figures

# ---- a scene of one's own -------------------------------------------------------
says 'cubic Neo-Hookean law' 'make choose says which law' \
    "$MAKE" choose SCENE=lessons/scenes/guyed.scene ERROR=10% VERIFIED=yes
says '^Enough for 10 %: quadratic triangles' 'and which triangles, where linear ones err' \
    "$MAKE" choose SCENE=lessons/scenes/strip.scene
says 'Verified: the answer differs by 9.1 %' 'and by quadratic ones how far off it is' \
    "$MAKE" choose SCENE=lessons/scenes/leaning.scene VERIFIED=yes
says '^  from that of quadratic triangles.*in motion' 'in motion, too' \
    "$MAKE" choose SCENE=lessons/scenes/probe.scene VERIFIED=yes
says 'Drawn: build/mine/choose.svg' 'and draws its parts and the body' \
    "$MAKE" choose SCENE=lessons/scenes/buckled.scene
says 'NOT SURE' 'make choose says what it cannot do' \
    "$MAKE" choose SCENE=lessons/scenes/stout.scene ERROR=0.5%
says "line 2: 'heigth' is no word" 'make choose names a bad line' \
    sh -c 'printf "width 1\nheigth 2\n" >bad.scene; "$0" choose SCENE=bad.scene' \
    "$MAKE"
says 'stays straight where a column buckles' 'make choose knows a column' \
    "$MAKE" choose SCENE=lessons/scenes/straight.scene
"$MAKE" choose SCENE=lessons/scenes/straight.scene >said 2>&1
! grep -qE 'Price|solver|Expected' said
result $? 'what gives way has no price' "$(cat said)"
says 'Verified: no' 'and verifies nothing of it' \
    "$MAKE" choose SCENE=lessons/scenes/straight.scene VERIFIED=yes
says 'most of all since J is so far from 1' 'and why a model is not enough' \
    "$MAKE" choose SCENE=lessons/scenes/harder.scene
says '^Enough for 12 %: linear triangles, logarithmic law' 'and takes no cubic law beyond J = 2' \
    "$MAKE" choose SCENE=lessons/scenes/harder.scene ERROR=12%
sed 's/^pulled .*/pulled 1e6 0/' lessons/scenes/harder.scene >torn.scene
says 'the strain is so large that no body' 'make choose refuses what no body can bear' \
    "$MAKE" choose SCENE=torn.scene
sed 's/^end .*/end 100/' lessons/scenes/plunge.scene >long.scene
says 'the steps are too long' 'and steps that are too long' \
    "$MAKE" choose SCENE=long.scene
says '--error abc: must be a number from 0.01 to 100 %' \
    'make choose says which ERROR may be' \
    "$MAKE" choose SCENE=lessons/scenes/flap.scene ERROR=abc%
says 'takes VERIFIED=yes' 'make choose knows VERIFY' \
    "$MAKE" choose SCENE=lessons/scenes/flap.scene VERIFY=yes
says 'fastest motion over speed of sound' 'make choose has the Mach number' \
    "$MAKE" choose SCENE=lessons/scenes/plunge.scene
says 'by dissection, .* dense' 'and what each solver costs' \
    "$MAKE" choose SCENE=lessons/scenes/flap.scene
says 'fine enough: quadratic triangles' 'and which triangles are the cheapest' \
    "$MAKE" choose SCENE=lessons/scenes/strip.scene ERROR=1%
says 'of the force in the hand\.' 'make choose has the force in the hand' \
    "$MAKE" choose SCENE=lessons/scenes/probe.scene
says 'SCENE=FILE' 'make choose needs a scene' "$MAKE" choose
says 'make live ignores ERROR; that is for make choose' \
    'what make choose takes is for it alone' \
    env MAKELEVEL=0 MAKEFLAGS= "$MAKE" live ERROR=5%

# ---- the pages that run ------------------------------------------------------------
says 'make deps-web installs it' 'make web names what is missing' \
    env GSL_SOURCE=/nowhere "$MAKE" web

# ---- the window -------------------------------------------------------------------
if pkg-config --exists sdl2 2>/dev/null; then
    awk -f tests/tools/starter.awk solutions/24_live.c >lessons/24_live.c
    says 'this is its solution' 'make live runs the solution until 24 is written' \
        env SDL_VIDEODRIVER=dummy "$MAKE" live ARGS='--input pull'
    says 'frames are in' 'and mine from then on' \
        sh -c 'cp solutions/24_live.c lessons; SDL_VIDEODRIVER=dummy "$0" live \
            ARGS="--input pull" | grep -v solution' "$MAKE"
    says '  --law ' 'make live ARGS=--help prints' "$MAKE" live ARGS=--help
else
    echo 'skip cli: no SDL2 here'
fi
cd - >/dev/null && rm -rf "$copy"
