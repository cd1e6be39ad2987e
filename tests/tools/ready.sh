#!/bin/sh
# ready.sh FOLDER OBJECT... - what the main build has compiled, for another build in
# FOLDER that compiles the same (ANY_FLAGS=1): as old as it is.
set -u
: "${BUILD:=build}"
dir=$1
shift
for object; do
    to=$dir/${object#"$BUILD"/}
    [ -d "${to%/*}" ] || mkdir -p "${to%/*}"
    cp -p "$object" "$to"
done
cp -p "$BUILD/flags" "$dir"
