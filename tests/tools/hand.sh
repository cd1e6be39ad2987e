#!/bin/sh
# hand.sh NN_slug [FILE] - the scene of a lesson, with the slots that are written in
# FILE, the student's, in a window.
# hand.sh live - lesson 24; until all its slots are written, or with FORCE, its solution.
#
# Called by the Makefile with COMPILE, OBJECTS and LIBS.  ARGS are the scene's
# options; with --input there need be no window, and with WINDOW=no there is none.
# The frames go to a table, in MINE.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${ARGS:=}" "${MINE:=$BUILD/mine}" "${WINDOW:=}" "${FORCE:=}"
slug=$1 nn=${1%%_*}
if [ "$slug" = live ]; then
    mine=$BUILD/live file=lessons/24_live.c goal=live
    if [ -n "$FORCE" ] || [ ! -f $file ] || grep -q 'todo."24[a-z]"' $file; then
        file=solutions/24_live.c
        [ -n "$FORCE" ] || echo 'Lesson 24 has slots that are not written yet: this is' \
            'its solution.'
    fi
    set -- $file
else
    mine=$MINE/$slug.hand file=${2:-lessons/$slug.c} goal=live-$nn
    mkdir -p "$MINE" || exit 1
    if [ ! -f "$file" ]; then
        echo "$file is not there: the solution runs (make reset-$nn makes the starter)"
        file=solutions/$slug.c
    fi
    awk -v whose="$mine.whose" -f tests/tools/hand.awk "solutions/$slug.c" "$file" \
        >"$mine.c" || exit 1
    set -- -I. -DPROGRAM="\"$mine.c\"" -DHAND_WHOSE="\"$(cat "$mine.whose")\"" \
        "figures/$slug/hand.c"
fi
case " $ARGS " in
*' -h '* | *' --help '* | *' --input'*) window= ;;
*) window=yes ;;
esac
if [ "$WINDOW" != no ] && pkg-config --exists sdl2 2>/dev/null; then
    set -- "$@" common/motion/view_sdl.c $(pkg-config --cflags sdl2)
    LIBS="$LIBS $(pkg-config --libs sdl2)"
    OBJECTS=$(echo " $OBJECTS " | sed 's| [^ ]*/view\.o | |')
elif [ "$window" ] && [ "$WINDOW" != no ]; then
    echo "make $goal needs SDL2: apt install libsdl2-dev, or brew install sdl2" >&2
    exit 2
fi
# the words of the compiler name the student's file
$COMPILE "$@" -o "$mine" $OBJECTS $LIBS 2>"$mine.said" || {
    sed "s|$mine\.c|$file|" "$mine.said" >&2
    echo "$goal: WRONG (does not compile)" >&2
    exit 1
}
set -f
case " $ARGS " in *' -h '* | *' --help '*) exec "$mine" -h ;; esac
"$mine" $ARGS >"$mine.tsv" || exit
echo "The frames are in $mine.tsv"
