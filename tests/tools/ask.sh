#!/bin/sh
# ask.sh WHAT - which flags the compiler CC and this machine take: a line, or nothing.
#
# The Makefile asks it once of each ($(call once,WHAT)).
set -u
LC_ALL=C
export LC_ALL
: "${CC:=cc}"
takes() { # takes FLAGS...: print them, if CC takes them
    $CC -Werror "$@" -fsyntax-only -x c /dev/null 2>/dev/null && echo "$@"
}
links() { # links PROGRAM FLAGS...: print them, if CC makes the program with them
    program=$1
    shift
    echo "$program" | $CC -w -x c - -o /dev/null "$@" 2>/dev/null && echo "$@"
}
case $1 in
gsl) gsl-config --cflags --libs 2>/dev/null ;;
check) pkg-config --cflags --libs check 2>/dev/null || echo -lcheck ;;
llvm) em-config LLVM_ROOT 2>/dev/null ;;
native) # for this machine, of the list what CC takes
    set -- -O3 -march=native -mprefer-vector-width=512 -ffp-contract=fast
    takes "$@" || for flag in "$@"; do takes "$flag"; done ;;
less) # in place of -O3, with the same digits
    takes -O2 -ftree-vectorize -fvect-cost-model=dynamic -fpeel-loops || echo -O3 ;;
bounds) # an index beyond an array whose length the compiler knows is a trap
    takes -fsanitize=bounds -fsanitize-undefined-trap-on-error ||
        takes -fsanitize=bounds -fsanitize-trap=bounds ;;
linker) # the one that takes half as long
    name=${CC%% *}
    case ${name##*/} in cc | gcc* | clang* | ccache)
        ! command -v ld.gold >/dev/null || echo -fuse-ld=gold ;;
    esac ;;
lapack)
    program='int dpbtrf_(void); int main(void) { return dpbtrf_(); }'
    links "$program" -lopenblas || links "$program" -llapack ;;
cholmod)
    program='#include <cholmod.h>
        int main(void) { return !cholmod_start; }'
    links "$program" $(pkg-config --cflags --libs cholmod 2>/dev/null || echo -lcholmod) ||
        links "$program" -I/usr/include/suitesparse -lcholmod ;;
esac
