#!/bin/sh
# lint.sh [NN_slug] - rules of the tree that a compiler does not know.
#
# Prints "ok lint: RULE" or "FAIL lint: RULE: where"; with a lesson the rules of
# the lesson, and of the others what they find there: lines that name another
# lesson, or a file of common/ or tests/unit/, are left out.  A rule guards
# something that breaks; what reads well is judged by readers.
set -u
LC_ALL=C
export LC_ALL
only=${1:-}
elsewhere='(^|[^0-9])[0-9][0-9]_[a-z]|common/|tests/unit/|figures/[a-z]'
concerns() { # of lines of offenders, those that concern the lesson
    awk -v only="$only" -v elsewhere="$elsewhere" \
        'only == "" || index($0, only) || $0 !~ elsewhere'
}
rule() { # rule NAME OFFENDERS
    set -- "$1" "$(printf '%s\n' "$2" | concerns)"
    if [ -z "$2" ]; then echo "ok lint: $1"; else echo "FAIL lint: $1: $2"; fi
}
# a C file with a header of its name is what several studies share
studies=$(ls figures/*/*.c | grep -v '^figures/many/' | while read -r f; do
    [ -f "${f%c}h" ] || case $f in */hand.c) ;; *) echo "$f" ;; esac; done)
sources=$(ls common/*/*.[ch] lessons/choose/* solutions/*.c figures/*/*.[ch] tests/*/*.[ch])
lessons=${only:-$(for f in solutions/[0-9][0-9]_*.c; do basename "$f" .c; done)}

# ---- who may include whom ----------------------------------------------------
# Rooms of common/, the floor before each: a file includes its own room or one
# on a lower floor, and no header reaches itself.
floors='1 base 1 material 2 linear 3 bar 3 plane 3 particles 4 motion 4 choice'
rule 'common/ has its eight rooms' "$(ls common | while read -r room; do
    case " $floors " in *" $room "*) ;; *) echo "common/$room" ;; esac; done)"
included() { # included FILES: "file header" of each header of common/
    grep -H '^#include "' "$@" | sed 's/:[^"]*"/ /; s/".*//'
}
rule 'common/ includes its own room, or downwards' \
    "$(included common/*/*.[ch] | awk -v floors="$floors" '
        BEGIN { n = split(floors, f); for (k = 1; k < n; k += 2) floor[f[k + 1]] = f[k] }
        { split($1, from, "/"); split($2, to, "/")
          if (from[2] != to[1] && !(floor[to[1]] < floor[from[2]])) print $1 " includes " $2 }')"
rule 'no header of common/ reaches itself' \
    "$(included common/*/*.h | sed 's|^common/||' | tsort 2>&1 >/dev/null)"
# A public name begins with the name of its header, of its room (bar_, particle_
# or particles_), or with a noun that the header states ("Names: mat2_."); a noun
# belongs to one room.
names=$(for h in common/*/*.h; do
    awk -v f="$h" '
        NR == 1 { split(f, path, "/"); own = path[3]; sub(/\.h$/, "", own)
                  one = path[2]; sub(/s$/, "", one); n = 0 }
        /^ \* Names: / { text = $0; gsub(/.*Names: |\.$/, "", text)
                        n = split(text, noun, ", ") }
        /^[a-z].*\(/ && !/^(typedef|static|INLINE|extern)/ {
            name = $0; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name)
            good = index(name, own) == 1 || index(name, one "_") == 1 ||
                   index(name, path[2] "_") == 1
            for (k = 1; k <= n; k++) if (index(name, noun[k]) == 1) good = 1
            if (name != "" && !good) print "name", f ": " name }
        END { for (k = 1; k <= n; k++) print "noun", noun[k], path[2] }' "$h"
done)
rule 'names of common/ begin with their header, room or a stated noun' \
    "$(echo "$names" | sed -n 's/^name //p')"
rule 'a noun of common/ belongs to one room' \
    "$(echo "$names" | grep '^noun' | sort -u | awk '{ print $2 }' | uniq -d)"
# What the studies of one chapter call lies beside them; fibre_dpk1() stands with
# fibre_pk1(), and the tests have another clock (tests/tools/clock.c).
rule 'a function of common/ is called there, by a lesson, or by studies of two folders' \
    "$(awk '
        /^ *(\/\*|\*)/ { next }
        FILENAME ~ /^common\/.*h$/ && /^[a-z].*[(]/ && !/^(typedef|static|INLINE)/ {
            name = $0; sub(/[(].*/, "", name); sub(/.*[ *]/, "", name)
            if (name != "") home[name] = FILENAME
            next }
        FILENAME ~ /^common/ && /^[a-z]/ { next } # where it is defined
        { where = FILENAME
          if (!sub(/\/[^\/]*[.][ch]$/, "", where) || where !~ /^figures/ ||
              FILENAME ~ /hand[.]c$/) where = "lesson"
          while (match($0, /[A-Za-z_][A-Za-z0-9_]*/)) {
              word = substr($0, RSTART, RLENGTH); $0 = substr($0, RSTART + RLENGTH)
              if (word in home && !((word, where) in seen)) {
                  seen[word, where]; count[word] += where == "lesson" ? 2 : 1 } } }
        END { for (name in home) if (count[name] < 2) print home[name] ": " name }' \
        common/*/*.h common/*/*.[ch] solutions/*.c tests/checks/*.[ch] tests/oracle/*.h \
        lessons/choose/*.c lessons/web/*.c tests/web/*.c figures/*/*.[ch] | grep -v ' fibre_dpk1$\| clock_machine$')"
rule 'all headers of common/ can be included together' \
    "$(for h in common/*/*.h; do echo "#include \"${h#common/}\""; done |
        ${CC:-cc} -std=c17 -D_POSIX_C_SOURCE=200809L -Icommon \
            $(gsl-config --cflags 2>/dev/null) -w -fsyntax-only -x c - 2>&1)"
rule 'common/ knows no lesson' \
    "$(grep -nE '[0-9][0-9]_[a-z]|lessons/|solutions/' common/*/*.[ch])"
rule 'solutions include libc, GSL and common/; studies also what studies share, and lessons/choose/' \
    "$(included solutions/*.c $studies | while read -r file header; do
        [ -f "common/$header" ] || { case $header in ../../lessons/choose/*) ;; ../../*) false ;; esac &&
            [ -f "${file%/*}/$header" ] && [ "${file%%/*}" = figures ]; } ||
            echo "$file includes $header"; done)"
rule 'only figures/many/ needs PETSc or MPI' \
    "$(grep -lE '#include <(petsc|mpi)' $sources | grep -v '^figures/many/')"
rule 'only options, pointer, table, status and hand print in common/' \
    "$(grep -lE '\b(printf|puts|putchar|fputs|fprintf)\(' common/*/*.c |
        grep -vE '/(options|pointer|table|status|hand)\.c')"

# ---- shape of the code --------------------------------------------------------
rule 'lines of at most 80 columns' \
    "$(awk 'length > 80 { print FILENAME ":" FNR }' $sources)"
rule 'no // comments' "$(grep -nE '(^|[^:"])//' $sources)"
rule 'no -ffast-math anywhere' "$(grep -nE 'fast-math *$|-Ofast' Makefile | grep -vE 'filter|error')"
rule 'ulimit sets one limit at a time (dash takes no more)' \
    "$(grep -nE 'ulimit( +-[SH])* +-[a-z] +[0-9a-z]+ +-' Makefile tests/*.mk \
        tests/tools/*.sh tests/cli/*.sh)"
rule 'make 3.81 reads the makefiles (tests/tools/old_make.awk)' \
    "$(awk -f tests/tools/old_make.awk Makefile tests/*.mk)"
rule 'no parameter of an awk function is named like a function' \
    "$(awk -f tests/tools/parameters.awk tests/tools/*.awk figures/*.awk figures/*/*.awk)"
rule 'a solution begins with its slots, before line 70, in the order of their letters' \
    "$(awk 'FNR == 1 { before = "" }
        /\/\* SLOT [0-9]+[a-z]\(/ {
            slot = $0
            sub(/.*SLOT [0-9]+/, "", slot)
            slot = substr(slot, 1, 1)
            if (slot < before || (before == "" && FNR >= 70)) print FILENAME ":" FNR
            before = slot }' solutions/*.c)"
rule 'a study ends in its claim, and takes no options' \
    "$(grep -L ' claim(' $(echo "$studies" |
        grep -v '^figures/speed/\|/fronts\.c$\|/seconds\.c$')
    grep -L 'int main(void)' $studies)"

rule 'what checks know of a program comes first' \
    "$(for f in tests/checks/[0-9]*.c; do
        [ "$(grep -m 1 '^#include' "$f")" = '#include "program.h"' ] || echo "$f"
    done)"

# ---- what a contributor reads --------------------------------------------------
rule 'nothing is left to write (TODO)' \
    "$(grep -n TODO solutions/*.c solutions/*.md lessons/*.md tests/checks/*.c \
        tests/mistakes/*.txt figures/*/*.c figures/*/*.gp workbook.md |
        sed '1s/^/\
/')"
rule 'every header of common/ is once on the map of the library, with its room' \
    "$({ ls common/*/*.h lessons/choose/*.h figures/*/*.h
        awk '/^## /{ on = /Map of the library/ } on' workbook.md |
            grep -oE '\]\([a-z0-9_/]+\.h\)' | sed 's/^](\(.*\))$/\1/' | sort -u
        awk '/^## /{ on = /Map of the library/ } on' workbook.md |
            grep -oE '\]\([a-z0-9_/]+\.h\)' | sort | uniq -d; } |
        grep -v '^figures/many/' | sort | uniq -u)"

# ---- the book -----------------------------------------------------------------
book="workbook.md $(ls lessons/*.md solutions/*.md figures/*/README.md 2>/dev/null)"
rule 'every chapter is in the contents' \
    "$(for f in $book; do case $f in
        workbook.md | solutions/*) ;;
        *) grep -qF "]($f)" workbook.md || echo "$f" ;;
    esac; done)"
rule 'hints and answers are in solutions/, not in a chapter' \
    "$(grep -nE '<summary>(Hint|Answer)' workbook.md lessons/*.md figures/*/README.md)"
rule 'every formula survives Markdown (tests/tools/math.awk)' \
    "$(awk -f tests/tools/math.awk README.md $book)"
rule 'no line of text begins with a marker (Markdown would end the paragraph)' \
    "$(grep -nE '^ *<!-- n ' $book)"
order='Scene|Theory|Example|On paper|In code|Predict|Measured|Speed against accuracy|Break it|In one sentence|You now have|'
rule 'a lesson has its sections, in their order' \
    "$(for f in lessons/[0-9]*.md; do
        [ "$(sed -n 's/^## \(.*\)/\1/p' "$f" | grep -vx 'In your hand' |
            tr '\n' '|')" = "$order" ] || echo "$f"; done)"
rule 'neighbours of a chapter are those of the tree (make workbook)' \
    "$(sh tests/tools/workbook.sh led | grep stale)"
rule 'every link into a page finds its place (tests/tools/anchors.awk)' \
    "$(awk -f tests/tools/anchors.awk README.md $book README.md $book)"

# What the text links to, as FILE:TARGET from the top of the tree.
links=$(awk '
    FNR == 1 { fence = 0; dir = FILENAME; if (!sub(/[^\/]*$/, "", dir)) dir = "" }
    /^ *```/ { fence = !fence; next }
    fence { next }
    { line = $0
      while (match(line, /\]\([^)#][^)]*\)|<img src="[^"]*"/)) {
          to = substr(line, RSTART, RLENGTH)
          line = substr(line, RSTART + RLENGTH)
          sub(/^\]\(|^<img src="/, "", to)
          sub(/[)"]$/, "", to)
          sub(/#.*/, "", to)
          if (to ~ /^https*:/) continue
          to = dir to
          while (sub(/[^\/.][^\/]*\/\.\.\//, "", to)) { }
          sub(/^\.\//, "", to)
          print FILENAME ":" to
      } }' README.md $book)
rule 'every picture and file that the text names is there' \
    "$(echo "$links" | while IFS=: read -r f target; do
        [ -s "$target" ] || echo "$f: $target"; done)"

# ---- equation labels ----------------------------------------------------------
labels() { tr '\n' ' ' | grep -oE '\[(eq|alg):[A-Za-z0-9-]+\]' | tr -d '[]' | sort -u; }
undefined() { grep -vxF -e "$defined"; }
equations=$(grep -l '^| label | equation' workbook.md lessons/*.md)
defined=$(sed -n 's/^| \(<a [^>]*><.a>\)*\[\([a-z]*:[A-Za-z0-9-]*\)\] |.*/\2/p' "$equations")
cited=$(cat common/*/*.[ch] lessons/choose/*.[ch] solutions/*.c tests/checks/*.c figures/*/*.[ch] | labels)
rule 'no equation label is defined twice' "$(echo "$defined" | sort | uniq -d)"
rule "every label cited by code is defined in $equations" \
    "$(echo "$cited" | undefined)"
rule "every label of $equations is cited by code" \
    "$(echo "$defined" | grep -vxF -e "$cited")"
rule "every label cited in the book is defined in $equations" \
    "$(cat $book | labels | undefined)"
rule 'a label is a link, by itself: no other one, no bracket and no colon behind it' \
    "$(for f in $book; do
        awk '/^<!-- labels -->$/ { exit }
            { gsub(/\[(eq|alg):[^]]*\]\([^)#]*#answer-[0-9]+\)/, "") }
            /\[(eq|alg):[^]]*\][[(]/ || (/^ *\[(eq|alg):[^]]*\]:/ && before == "") {
                print FILENAME ":" FNR }
            { before = $0 }' "$f"; done)"

# ---- each lesson is whole -----------------------------------------------------
for slug in $lessons; do
    nn=${slug%%_*}
    missing=
    for file in "lessons/$slug.c" "lessons/$slug.md" "solutions/$slug.md" \
        "tests/checks/$slug.c" "tests/mistakes/$slug.txt"; do
        [ -f "$file" ] || missing="$missing $file"
    done
    ls figures/"$slug"/*.gp >/dev/null 2>&1 || missing="$missing figure"
    said=$(awk -v nn="$nn" -f tests/tools/whole.awk "solutions/$slug.c" \
        "lessons/$slug.md" "tests/checks/$slug.c" "tests/mistakes/$slug.txt" \
        "solutions/$slug.md" .clangd)
    of() { echo "$said" | sed -n "s/^$1 //p"; }
    rule "lesson $nn is whole" "$missing$(of whole)"
    rule "lesson $nn has its predictions" "$(of predictions)"
    rule "answers of lesson $nn have a fold each, with a name" \
        "$(awk -f tests/tools/answers.awk "lessons/$slug.md" "solutions/$slug.md")"
    rule "hints of lesson $nn name checks or slots that exist" "$(of hints)"
    rule "mistakes of lesson $nn name checks that exist" "$(of mistakes)"
done

# Every deliberate mistake fits its file; a line for each that does not.
unfit=$(
    for list in tests/mistakes/${only:-*}.txt tests/unit/mistakes.txt tests/many/mistakes.txt; do
        [ -z "$only" ] || [ "$list" = "tests/mistakes/$only.txt" ] || continue
        program=solutions/$(basename "$list" .txt).c
        case $list in
        tests/unit/*) program=./ ;;
        tests/many/*) program=figures/many/ ;;
        esac
        awk -f tests/tools/variant.awk -v check="$program" "$list" |
            sed "s|^|FAIL lint: $list: |"
    done
)
echo "${unfit:-ok lint: every deliberate mistake fits its file}"

# ---- figures ------------------------------------------------------------------
plots=$(ls figures/*/*.gp)
moving=$(grep -l '^set terminal gif' $plots)
pictures=$(for f in $plots; do # what the scripts make
    case " $(echo $moving) " in
    *" $f "*) echo "${f%.gp}.gif" ;;
    *) echo "${f%.gp}.svg" ;;
    esac; done)
rule 'every figure is committed' \
    "$(for f in $pictures; do [ -s "$f" ] || echo "$f"; done)"
rule 'every figure is in the book' \
    "$(echo "$pictures" | grep -vxF -e "$(echo "$links" | sed 's/.*://')")"
rule 'the map of the course shows what the chapters say (make figures)' \
    "$( (awk -f figures/map.awk lessons/[0-9]*.md figures/*/README.md |
        cmp - figures/map.svg) 2>&1)"
rule 'every label of an axis is in the picture, where the margin may have no room for it' \
    "$(for f in $plots; do
        [ ! -f "${f%.gp}.svg" ] || echo "$f" "${f%.gp}.svg"
    done | xargs awk -f tests/tools/labels.awk)"
rule 'a figure that shows seconds names the machine' \
    "$(grep -lE 'seconds|\(ms\)|\(ns\)' $plots | while read -r f; do
        grep -q 'machine(' "$f" || echo "$f"; done)"

# ---- how much there is ----------------------------------------------------------
[ -n "$only" ] || sh tests/tools/budget.sh lint
