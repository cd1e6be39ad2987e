#!/bin/sh
# copy.sh FOLDER [NN_slug] - a copy of the workbook, for a test that changes it.
#
# What is built comes with it, so that nothing is compiled twice: the library
# and the judge; of the lesson its solution and its known mistakes, or without
# one all solutions and all data.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
to=$1 slug=${2:-}
rm -rf "$to" && mkdir -p "$to/build/solutions" || exit 1
cp -Rp Makefile .clangd common lessons solutions tests figures ./*.md "$to"
cp -Rp "$BUILD/common" "$BUILD/libworkbook.a" "$BUILD/tests" "$BUILD/checks" \
    "$BUILD/flags" "$to/build"
for header in figures/*/*.h; do # what studies share is in the library
    object=$BUILD/${header%.h}.o
    [ ! -f "$object" ] || { mkdir -p "$to/build/${header%/*}" &&
        cp -p "$object"* "$to/build/${header%/*}"; }
done
if [ -z "$slug" ]; then
    cp -Rp "$BUILD/solutions" "$BUILD/data" "$to/build"
    exit
fi
cp -p "$BUILD/solutions/$slug" "$BUILD/solutions/$slug.judge" \
    "$BUILD/solutions/$slug.judge.s" "$to/build/solutions"
mkdir -p "$to/build/mistakes/$slug"
for file in "$BUILD/mistakes/$slug"/*; do # no folder of a judge that is at work
    case $file in
    *.part) ;;
    *) [ ! -f "$file" ] || cp -p "$file" "$to/build/mistakes/$slug" ;;
    esac
done
