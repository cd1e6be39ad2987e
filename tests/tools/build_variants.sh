#!/bin/sh
# build_variants.sh KIND - build everything with other tools or flags.
#
# KIND is gcc or clang (no warning under the strict set), sanitize (ASan and
# UBSan), valgrind (no leak, no invalid access).  Prints ok, FAIL, skip lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
kind=$1 dir=$BUILD/$1
result() {
    if [ "$1" = 0 ]; then echo "ok $kind: $2"; else echo "FAIL $kind: $2: $3"; fi
}
have() { # have COMMAND ARGS...: it compiles a program that runs
    echo 'int main(void) { return 0; }' >"$dir.c" &&
        "$@" "$dir.c" -o "$dir.out" >/dev/null 2>&1 && "$dir.out"
}
mkdir -p "$dir"
case $kind in
gcc | clang)
    if ! have "$kind"; then echo "skip $kind: not on this machine"; exit 0; fi
    said=$("$MAKE" all BUILD="$dir" CC="$kind" CFLAGS='-O1 -Werror' 2>&1)
    result $? 'everything compiles without a warning' "$said" ;;
sanitize)
    flags='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all'
    if ! have "${CC:-cc}" $flags; then echo 'skip sanitize: no ASan here'; exit 0; fi
    said=$("$MAKE" programs studies BUILD="$dir" CFLAGS="$flags" 2>&1)
    result $? 'everything compiles' "$said" ;;
valgrind)
    if ! command -v valgrind >/dev/null; then
        echo 'skip valgrind: not on this machine'
        exit 0
    fi
    # without the flags for this machine: valgrind does not know AVX-512
    said=$("$MAKE" programs BUILD="$dir" CFLAGS="-O1 -g" NATIVE= 2>&1)
    result $? 'everything compiles for any machine' "$said" ;;
esac
[ $kind = sanitize ] || [ $kind = valgrind ] || exit 0
run=
[ $kind = sanitize ] || run='valgrind -q --leak-check=full --error-exitcode=9'
# The default run of every solution; of every study under the sanitizers, which
# are quicker than valgrind.
set -- "$dir"/solutions/[0-9][0-9]_*
[ $kind = valgrind ] || set -- "$@" "$dir"/figures/*/*
for program in "$@"; do
    case ${program##*/} in *.*) continue ;; esac
    said=$($run "$program" 2>&1 >/dev/null)
    result $? "${program#"$dir"/} is clean" "$said"
done
for program in "$dir"/unit/*; do
    case ${program##*/} in *.*) continue ;; esac
    # these compute for long, and valgrind takes forty times as long
    case $kind.${program##*/} in
    valgrind.body | valgrind.matrix | valgrind.robustness | valgrind.work)
        continue ;;
    esac
    # Check keeps its own structures to the end of the process
    said=$(ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
        $(echo "$run" | sed 's/--leak-check=full//') \
        "$program" 2>&1)
    result $? "unit $(basename "$program") is clean" "$said"
done
