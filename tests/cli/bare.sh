#!/bin/sh
# bare.sh - `make deps GOALS` on a machine that has no compiler, GSL or gnuplot yet:
# nothing starts before deps has ended, and all is asked anew then, so that the first
# run compiles as the second does, with apt and with Homebrew.  What deps says where
# it cannot install.  Prints "ok ..." or "FAIL ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok bare: $2"; else echo "FAIL bare: $2: $3"; fi
}
copy=$BUILD/test/copy.bare
rm -rf "$copy" && mkdir -p "$copy/few" "$copy/tools" "$copy/away" || exit 1
cp -Rp Makefile common lessons solutions tests figures ./*.md "$copy" &&
    cd "$copy" || exit 1
here=$PWD
script() { # script FILE: its lines are read
    { echo '#!/bin/sh' && cat; } >"$1" && chmod +x "$1"
}
bare() { # bare FOLDER GOAL...: on a machine that has the programs in FOLDER
    path=$here/$1
    shift
    said=$(env -i PATH="$path" TMPDIR="$here" "$MAKE" "$@" 2>&1 </dev/null)
    status=$?
}
without_make() { printf '%s\n' "$said" | grep -v '\*\*\* \[\|recipe for target'; }

# ---- nothing starts before deps has ended --------------------------------------
# Any program but the shell leaves a line in `early`.
for name in sh getconf sleep "$MAKE"; do
    ln -s "$(command -v "$name")" few
done
for name in ar awk cat cc clang cp emcc find gcc gnuplot grep gsl-config mkdir mpicc \
    mv node pandoc pkg-config printf sed valgrind; do
    echo "echo '$name' \"\$*\" >>'$here/early'; exit 1" | script few/$name
done
cp tests/tools/deps.sh deps.sh
echo 'sleep 1; exit 1' >tests/tools/deps.sh
goals='status figures course book web test live bench many grade lint starters
    workbook studies memcheck look clean test-web figure-many figure-03 verify-03
    mutants-03 workbook-03 mistakes-03 lesson-03 check-03 hint-03 diff-03 plot-03
    watch-03 debug-03 build/common/base/status.o'
bare few -j8 $goals deps
[ $status = 2 ] && [ ! -e early ] && [ -z "$(without_make)" ]
result $? 'nothing starts before deps has ended' "$said $(cat early 2>&1)"
cp Makefile whole
sed -e 's/^then: .*/then:/' -e '/^.NOTPARALLEL/d' whole >Makefile
bare few -j8 $goals deps
[ -s early ]
result $? 'and it is noticed where something does' "$said"
mv whole Makefile
mv deps.sh tests/tools/deps.sh

# ---- what is asked is asked anew -------------------------------------------------
# `tools` has all that is here but what deps installs, which comes out of `away`.
compiler=$(command -v "${CC:-cc}") gsl=$(command -v gsl-config)
echo "$PATH" | tr : '\n' | while IFS= read -r folder; do
    ln -s "$folder"/* tools 2>/dev/null # what is there already stays
done
for name in gnuplot pkg-config; do
    ln -s "$(command -v $name)" away
done
rm -f tools/cc tools/gcc tools/gnuplot tools/gsl-config tools/pkg-config \
    tools/pkgconf tools/apt-get tools/brew tools/id
mkdir -p homebrew/include hide/gsl
ln -s "$($gsl --prefix)/include/gsl" homebrew/include
for header in math linalg; do
    echo '#error not here' >hide/gsl/gsl_$header.h
done
script away/gsl-config <<END
[ \$1 != --cflags ] || exec echo '-I$here/homebrew/include'
exec $gsl "\$@"
END
# GSL is found by gsl-config's word alone; the compiler may look for another one
echo "PATH='$PATH'; exec $compiler \"\$@\" '-I$here/hide'" | script away/cc
echo 'echo 0' | script tools/id
installs() { # installs PROGRAM: which does, after a while
    script tools/$1 <<END
case " \$* " in *' install '*) sleep 2 && mv '$here/away'/* '$here/tools' ;; esac
END
}
commands() { # what is compiled, of what make has printed: a line each
    printf '%s\n' "$said" | sed -e ':a' -e '/\\$/{N;s/\\\n//;ba' -e '}' |
        grep -e ' -c ' | sort
}
same() { # same WHAT GOAL...: with and after deps
    what=$1
    shift
    bare tools V=1 deps "$@"
    commands >first
    first=$status why=$said
    rm -rf build
    bare tools -n "$@"
    commands >second
    [ $first = 0 ] && [ $status = 0 ] && [ -s first ] && cmp -s first second &&
        ! grep -q -v -F -e "$here/homebrew" first
    result $? "$what" "status $first, $status; $(diff first second | cut -c 1-300) $why"
}
cp solutions/03_dirichlet_correction.c lessons
installs apt-get
same 'the first run compiles as the second does, with apt' figure-many lesson-03 \
    build/common/linear/tiles.o build/unit/unit.o
mv tools/gnuplot tools/pkg-config tools/gsl-config away
rm tools/apt-get
installs brew
same 'and with Homebrew' figure-many lesson-03

# ---- where deps cannot install ---------------------------------------------------
mv tools/gnuplot away
rm tools/brew
says() { # says WHAT TEXT: in one line, and status does not follow
    bare tools deps status
    [ $status = 2 ] && [ "$(without_make | grep -c -v '^  deps ')" = 1 ] &&
        without_make | grep -q -e "^deps: $2"
    result $? "$1" "status $status; $said"
}
echo 'echo "E: no network"; echo more; exit 100' | script tools/apt-get
says 'without a network deps says why' 'apt-get failed: E: no network (the whole'
echo 'echo 1000' | script tools/id
says 'another user than root is told what to run' \
    'missing: gnuplot; run:  sudo apt-get update && sudo apt-get install .* gnuplot-nox'
rm tools/apt-get
says 'without apt and Homebrew deps says what to install' 'missing: gnuplot\. Install'
cd - >/dev/null && rm -rf "$copy"
