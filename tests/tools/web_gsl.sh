#!/bin/sh
# web_gsl.sh source    where GSL's source is: GSL_SOURCE, or what make deps-web has
#                      fetched into BUILD/source; nothing: nowhere
# web_gsl.sh build     BUILD/wasm/gsl: its headers, config.h and libgsl.a, by emcc
# web_gsl.sh wasi      BUILD/wasi/libgsl.a, by CC, with these headers, and with what
#                      the checks call
#
# Of GSL only what the programs call is compiled, of the files in the list below;
# one that is missing there the linker asks for by what it defines.
set -u
LC_ALL=C
export LC_ALL
build=${BUILD:-build}
source=${GSL_SOURCE:-$(ls "$build"/source/gsl_*.orig.tar.gz 2>/dev/null | head -n 1)}
if [ "$1" = source ]; then
    [ ! -e "$source" ] || echo "$source"
    exit 0
fi
files='blas/blas block/init cblas/dasum cblas/daxpy cblas/dcopy cblas/ddot cblas/dgemv
cblas/dnrm2 cblas/dscal cblas/dsymv cblas/dsyr cblas/dsyr2 cblas/dsyrk
cblas/dtbsv cblas/dtrsm cblas/dtrsv cblas/idamax cblas/xerbla eigen/symm
err/error err/stream integration/glfixed linalg/cholesky linalg/householder
linalg/ldlt_band linalg/symmtd matrix/init matrix/rowcol matrix/submatrix
matrix/swap matrix/view rng/inline rng/mt rng/rng sort/sortvec specfunc/log
sys/pow_int vector/copy vector/init vector/oper vector/subvector vector/view'
for_checks='cblas/dgemm cblas/dger cblas/drot cblas/drotg cblas/drotm cblas/drotmg
cblas/dswap cblas/dsymm cblas/dsyr2k cblas/dtrmm cblas/dtrmv eigen/gensymm eigen/gensymmv eigen/sort
eigen/symmv integration/qag integration/qk integration/qk15 integration/qk21
integration/qk31 integration/qk41 integration/qk51 integration/qk61
integration/workspace linalg/inline linalg/lu matrix/matrix permutation/init
permutation/permutation permutation/permute randist/shuffle sys/coerce sys/hypot
sys/fcmp sys/fdiv sys/infnan matrix/copy vector/swap vector/vector'
: "${NODE_PATH:=/usr/share/nodejs}" # Debian's acorn, for any node
export NODE_PATH
unset LIBS LDFLAGS CPPFLAGS # this machine's, which configure would take
# Far from here, because configure refuses a path with a blank or an apostrophe.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' 0
trap 'exit 130' 1 2 15
log=$build/wasm/gsl.$1.log
mkdir -p "$build/wasm/gsl/gsl" && : >"$log" || exit 1
failed() {
    tail -n 3 "$log" >&2
    # why a program of configure's was not compiled is said only there
    cat "$work/config.log" >>"$log" 2>/dev/null && grep -m 3 'error:' "$work/config.log" >&2
    echo "web: GSL cannot be built; the whole log is $log" >&2
    exit 1
}
if [ -d "$source" ]; then cp -R "$source" "$work/source"
else mkdir "$work/source" && tar -xzf "$source" --strip-components=1 -C "$work/source"
fi >>"$log" 2>&1 || failed
if [ "$1" = wasi ]; then
    for file in $files $for_checks; do
        echo "$CC -std=gnu17 -O2 -w -ffp-contract=off -DHAVE_CONFIG_H -I$build/wasm/gsl" \
            "-I$work/source -I$work/source/${file%/*} -c $work/source/$file.c" \
            "-o $work/$(echo "$file" | tr / _).o"
    done | tr '\n' '\0' | xargs -0 -n 1 -P "$(getconf _NPROCESSORS_ONLN)" sh -c \
        >>"$log" 2>&1 && rm -f "$build/wasi/libgsl.a" &&
        emar rcs "$build/wasi/libgsl.a" "$work"/*.o >>"$log" 2>&1 || failed
    exit 0
fi
# For the host, which is another one with 32 bits, configure runs nothing.
(cd "$work" && emconfigure source/configure --host=i686-pc-linux-gnu \
    --disable-shared --disable-dependency-tracking CFLAGS=-O2 &&
    make -C gsl) >>"$log" 2>&1 || failed
for file in $files; do
    echo "emcc -std=gnu17 -O2 -ffp-contract=off -DHAVE_CONFIG_H -I. -Isource" \
        "-Isource/${file%/*} -c source/$file.c -o $(echo "$file" | tr / _).o"
done | tr '\n' '\0' | (cd "$work" && xargs -0 -n 1 -P "$(getconf _NPROCESSORS_ONLN)" \
    sh -c) >>"$log" 2>&1 || failed
emar rcs "$work/libgsl.a" "$work"/*.o >>"$log" 2>&1 &&
    cp -L "$work"/gsl/*.h "$build/wasm/gsl/gsl" &&
    cp "$work/config.h" "$build/wasm/gsl" &&
    cp "$work/libgsl.a" "$build/wasm/gsl" || failed
