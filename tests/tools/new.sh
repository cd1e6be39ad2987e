#!/bin/sh
# new.sh NN NAME - the files of a new lesson, from tests/tools/skeleton/.
#
# They are a whole lesson, of a line and its integral, which passes its checks:
# it is changed until it is the one that was meant.  What is to be written says
# TODO, and lint lists it.
set -u
LC_ALL=C
export LC_ALL
nn=$1 name=$2
stop() { echo "make new: $1" >&2; exit 2; }
case $nn in [0-9][0-9]) ;; *) stop "a lesson has a number of two digits" ;; esac
case $name in
'' | [!a-z]* | *[!a-z0-9_]*)
    stop "NAME is a word of a-z, 0-9 and _, as in make new-27 NAME=spring" ;;
esac
for f in */"$nn"_*; do
    [ ! -e "$f" ] || stop "lesson $nn is there: $f"
done
place=$(awk -v free=1 -f figures/map.awk lessons/[0-9]*.md figures/*/README.md) ||
    exit 2
write() { # write SKELETON FILE
    sed "s/@NN@/$nn/g; s/@N@/${nn#0}/g; s/@NAME@/$name/g; s/@PLACE@/$place/g" \
        "tests/tools/skeleton/$1" >"$2" || exit 2
    echo "  new      $2"
}
slug=${nn}_$name
mkdir -p "figures/$slug" || exit 2
write solution.c "solutions/$slug.c"
write solution.md "solutions/$slug.md"
write chapter.md "lessons/$slug.md"
write checks.c "tests/checks/$slug.c"
write mistakes.txt "tests/mistakes/$slug.txt"
write study.c "figures/$slug/order.c"
write study.gp "figures/$slug/order.gp"
awk -f tests/tools/starter.awk "solutions/$slug.c" >"lessons/$slug.c" || exit 2
echo "  starter  lessons/$slug.c"
# a row in the contents, behind the lesson before
part=workbook.md.$$.part
trap 'rm -f "$part"' EXIT
awk -v nn="$nn" -v slug="$slug" '
    function row() {
        if (done++) return
        printf "| <img src=\"figures/%s/order.svg\" width=\"120\"> ", slug
        printf "| [%s TODO: title](lessons/%s.md) ", nn, slug
        print "| TODO: what it is about, in a sentence. |"
    }
    /^\| <img src="figures\/[0-9]/ {
        match($0, /\]\(lessons\/[0-9]+/)
        if (substr($0, RSTART + 10, 2) > nn) row()
        rows = 1
    }
    rows && !/^\| <img src="figures\/[0-9]/ { row() }
    { print }' workbook.md >"$part" && mv "$part" workbook.md || exit 2
echo "  new      workbook.md: a row in the contents"
printf '%s\n' --- "{If: {PathMatch: tests/checks/$slug.c}, CompileFlags: {Add: ['-DPROGRAM=\"solutions/$slug.c\"']}}" \
    >>.clangd
echo "  new      .clangd: an editor reads the checks with the solution"
