# same_way.sh - many judges of programs in $file: to be sourced.
#
# Called with BUILD, MAKE, file, dir and slug set.  make does the same for each of
# them: it builds the first, is asked what it does for the second, and that is
# done for all others.

built=0 commands=
by_make() { # by_make FLAGS...: $file to the judge $dir/judge
    "$MAKE" "$dir/judge" BUILD="$BUILD" CFLAGS='-O0 -w' FILE="$file" \
        INTO="$dir/judge" SLUG="$slug" ANY_FLAGS=1 "$@" 2>&1
}
same_way() {
    rm -f "$dir/judge"
    built=$((built + 1))
    if [ $built = 1 ]; then by_make; return; fi
    [ -n "$commands" ] || commands=$(by_make -n)
    sh -c "$commands" 2>&1
}
