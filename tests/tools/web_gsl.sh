#!/bin/sh
# web_gsl.sh source    where GSL's source is: GSL_SOURCE, or what make deps-web has
#                      fetched into BUILD/source; nothing: nowhere
# web_gsl.sh build     BUILD/wasm/gsl: its headers and libgsl.a, by emcc
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
gsl=$build/wasm/gsl
rm -rf "$gsl" && mkdir -p "$gsl" || exit 1
log=$gsl/build.log
failed() {
    tail -n 3 "$log" >&2
    echo "web: GSL cannot be built; the whole log is $log" >&2
    exit 1
}
if [ ! -d "$source" ]; then
    mkdir "$gsl/source" && tar -xzf "$source" --strip-components=1 -C "$gsl/source" \
        >"$log" 2>&1 || failed
    source=$gsl/source
fi
source=$(cd "$source" && pwd)
cd "$gsl" || exit 1
log=build.log
# The host is another one with 32 bits, so that configure runs nothing; its headers
# are links into the source.
{ emconfigure "$source/configure" --host=i686-pc-linux-gnu --disable-shared \
    --disable-dependency-tracking CFLAGS=-O2 && make -C gsl; } >"$log" 2>&1 || failed
for file in $files; do
    object=$(echo "$file" | tr / _).o
    echo "emcc -std=gnu17 -O2 -ffp-contract=off -DHAVE_CONFIG_H -I. -I'$source'" \
        "-I'$source/${file%/*}' -c '$source/$file.c' -o $object"
done >commands
tr '\n' '\0' <commands |
    xargs -0 -P "$(getconf _NPROCESSORS_ONLN)" -n 1 sh -c >>"$log" 2>&1 || failed
emar rcs libgsl.a ./*.o >>"$log" 2>&1 || failed
