#!/bin/sh
# names.sh NN_slug - a right program is OK whatever its names and macros are.
#
# The solution, with names and macros added that its checks use as well, and with a
# table of its own, is judged.  Prints "ok ..." or "FAIL ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
slug=$1
nn=${slug%%_*} solution=solutions/$slug.c check=tests/checks/$slug.c
dir=$BUILD/test/names.$nn
file=$dir/$slug.c
rm -rf "$dir" && mkdir -p "$dir"
trap 'rm -rf "$dir"' EXIT
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok $2"; else echo "FAIL $2: $3"; fi
}
words() { grep -oE '[A-Za-z_][A-Za-z_0-9]*' | sort -u; }

# What comes to mind.
likely='cell run column word table row energy error norm residual_of check expect
    oracle exact order solve is_prescribed is_held assemble_all node element area
    claim claims lesson rules runs scene state load nodes values grid mixed wave
    square solved answer armijo reason of one two odd move shift deform potential
    ragged given prescribed EPS TOL TOLERANCE N_DOF N_NODE N_VERTEX ROUND_OFF n N
    tol PI eps dim i j k e a b x u h F J P r s t E K DIM SIZE quit judge judged
    guarded_copy word_at find_table output_free NOT_COMPARED COUNT NULL NAN wrong
    bar material LOG CUBIC fabs sqrt M_PI double static if'
# What the judge, its libraries and programs call, and what else comes to mind; but
# memcpy and its like, to which a compiler may make calls of its own.
system='_exit abs access atoi calloc chdir chmod clock_gettime close closedir div dup2
    exit execl fclose fopen fork fread free gamma getenv getline getpid index j0 kill
    malloc mkdtemp nanosleep open opendir perror pipe printf prctl puts qsort
    read readdir realloc recv remove rename rmdir sched_setscheduler setrlimit setsid
    signal sigaction snprintf socketpair strlen syscall time unlink wait waitpid write
    y1'

. tests/tools/same_way.sh
judged() { # judged WHAT
    same_way >"$dir/log" && "$dir/judge" --file "$file" \
        --reference "$BUILD/solutions/$slug" >"$dir/log" 2>&1
    said=$(cat "$dir/log")
    echo "$said" | tail -n 1 | grep -q "^VERDICT $nn: OK"
    result $? "$nn: a program $1 is judged OK" "$(echo "$said" | tail -n 20)"
}
# after_includes TEXT: the solution with TEXT behind its last #include
after_includes() {
    TEXT=$1 awk 'NR == FNR { if (/^#include/) last = FNR; next }
        { print } FNR == last { print ENVIRON["TEXT"] }' "$solution" "$solution"
}

# all the words that the checks are written in, and what they include of ours
{ echo "$likely" && cat "$check" tests/checks/judge.h tests/checks/output.h \
    $(sed -n 's|^#include "../\(.*\)"|tests/\1|p' "$check"); } | words |
    grep -v -e '^_' -e '^defined$' >"$dir/spoken"
# those to which neither the language, the solution nor the system gives a meaning
{ cat "$solution"; grep '^#include <' "$check"; } >"$file"
{ ${CC:-cc} -std=c17 -D_POSIX_C_SOURCE=200809L -Icommon \
    $(gsl-config --cflags) -E -dD "$file" && sed '/^[#"]/d' "$file"
    echo auto break case char const continue default do double else enum extern \
        float for goto if inline int long main register restrict return short \
        signed sizeof static struct switch typedef union unsigned void volatile \
        while program_main; } |
    sed '/^# /d' | words | comm -13 - "$dir/spoken" >"$dir/free"
# all of them as the linker's names too; and functions of the system's names,
# which the lesson's headers do not have: the judge calls some of them, and every
# second one is the linker's name too.  What the checks compile once more is the
# program's as well, and the function of the first slot has another name, unless a
# struct has it too.
of_checks() {
    awk '{
        print "struct " $1 " { int " $1 "; }; int " $1 "(int " $1 ");"
        print "int " $1 "(int " $1 ") { return " $1 "; }" }' "$dir/names"
}
printf '%s\n' $system | sort >"$dir/system"
${CC:-cc} -std=c17 -D_POSIX_C_SOURCE=200809L -Icommon $(gsl-config --cflags) \
    -E "$solution" | sed 's/__attribute__.*//' | words | comm -13 - "$dir/system" >"$dir/others"
comm -23 "$dir/free" "$dir/others" >"$dir/names"
of_system() { # of_system 0|1: which of them are the linker's
    awk -v odd="$1" '{
        linked = NR % 2 == odd ? "" : "static "
        print linked "int " $1 "(double, double);"
        print linked "int " $1 "(double a, double b) { return a > b; }" }' \
        "$dir/others"
}
count() { echo $(($(wc -l <"$1"))); }
slot=$(awk '/^static .*\(/ { sub(/\(.*/, ""); sub(/.*[ *]/, ""); name = $0 }
    /\/\* SLOT / { print name; exit }' "$solution")
sed -n 's/^\(#include ".*\)\.c"/\1.h"/p' "$check" >"$dir/modules"

after_includes "$(of_checks; of_system 0)" | awk '/return table_finish\(\);/ {
        print "table_begin(\"mine\", \"x\"); table_row(2.385); table_end();" }
    { print }' >"$file"
judged "with $(count "$dir/names") names of the checks, $(count \
    "$dir/others") functions of the system's names and a table of its own"

macro=
grep -q "struct $slot " "$solution" || macro="#define $slot my_$slot"
{ after_includes "$(cat "$dir/modules" && of_system 1 && printf '%s\n' "$macro" \
    '#ifndef M_PI' '#define M_PI 3.14159265358979323846' '#endif')"
    awk -v but="${macro:+$slot}" '$1 != but {
        print "#define " $1 (NR % 2 ? " 4" : "(x) (4)") }' "$dir/spoken"
} >"$file"
judged "with the rest of these, $(tr '\n' ' ' <"$dir/modules" |
    sed 's/#include //g')${macro:+a macro for $slot }and $(count "$dir/spoken") more"

if grep -q '^struct [a-z_0-9]* {$' "$solution"; then
    sed '/^struct [a-z_0-9]* {$/,/^}/s/^}/    double and_mine[3]; }/' "$solution" >"$file"
    judged 'with one member more in each of its structs'
    [ ! -e 0 ] # the name of a file, where awk takes it for a number
    result $? "$nn: which leaves no file of awk's" 0
fi
