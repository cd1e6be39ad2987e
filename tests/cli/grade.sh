#!/bin/sh
# grade.sh - `make grade` on a small class that has everything in it.  Prints
# "ok ..." or "FAIL ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
slug=03_dirichlet_correction
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then printf 'ok cli: %s\n' "$2"; else printf 'FAIL cli: %s: %s\n' "$2" "$3"; fi
}
copy=$BUILD/test/copy.grade
BUILD="$BUILD" sh tests/tools/copy.sh "$copy" $slug || exit 1
cd "$copy" || exit 1
variant() {
    awk -f tests/tools/variant.awk -v name="$1" "tests/mistakes/$slug.txt" \
        "solutions/$slug.c"
}
state() {
    find solutions common tests Makefile build/solutions build/mistakes class \
        -type f -exec cksum {} + -exec ls -ldn {} + | sort
}

# ---- the class ----------------------------------------------------------------
for student in Zo"$(printf '\303\253')" "O'Neill, \"Sean\"" -dash 'two twice' \
    'Mallory ' nobody ann bob eve fay gil ivy; do
    mkdir -p "class/$student/handed in"
done
variant lift_sign >"class/O'Neill, \"Sean\"/handed in/$slug.c"
variant elimination_and_reexpansion >"class/Zo$(printf '\303\253')/$slug.c"
awk -f tests/tools/starter.awk "solutions/$slug.c" >"class/-dash/$slug.c"
cp "solutions/$slug.c" "class/two twice/$slug.c"
cp "solutions/$slug.c" "class/two twice/handed in/$slug.c"
echo 'no lesson' >"class/two twice/99_nothing.c"
ln -s ../../solutions "class/two twice/link"
# one that means to spoil the others' verdicts, and the workbook
export hostile='for (int k = 1; k < 9; k++) {
        char name[99];
        sprintf(name, "../../../000%d.SLUG/result", k);
        FILE *f = fopen(name, "w");
        if (f) fputs("WRONG - - -", f), fclose(f);
    }
    system("cd HERE && rm -rf solutions build class 2>&-");
    kill(getppid(), SIGKILL);
    kill(0, SIGKILL);'
spoil() { # spoil HEADER...: the solution, with what is hostile in its first slot
    printf '#include <%s.h>\n' "$@"
    awk '{ print }
        /\/\* SLOT / { comment = !done++ }
        comment && /\*\// { comment = 0; print ENVIRON["hostile"] }' \
        "solutions/$slug.c" | sed "s|SLUG|$slug|g; s|HERE|$PWD|g"
}
spoil signal stdio stdlib unistd >"class/Mallory /$slug.c"
# ann's, as a browser names it, and bob's are Sean's but for comments and blanks;
# gil has the solution's text, eve includes it, fay wrote UTF-16
variant reaction_sign >"class/ivy/$slug.c"
variant lift_sign | tee "class/ann/$slug (1).c" |
    sed -e 's|/\*.*\*/||; s/    /	/' -e 's/$/ /' >"class/bob/$slug.c"
{ echo '/* all'; echo 'mine */'; cat "solutions/$slug.c"; } >"class/gil/$slug.c"
echo "#include \"../../../../solutions/./$slug.c\"" >"class/eve/$slug-2.c"
printf '\377\376/\000*\000' >"class/fay/$slug.c"
ln -s "$PWD/solutions" class/everyone
echo text >class/a.txt
mkdir "class/$(printf 'a\nb')"
cp "solutions/$slug.c" "class/$(printf 'a\nb')"

# a name whose backslashes are none, with eve's text; a formula as a name, whose
# program prints an escape character and the teacher's variables; and two dots
mkdir "class/w\\t(log)" class/=1+1 class/..dots
cp "class/eve/$slug-2.c" "class/w\\t(log)/$slug.c"
hostile='fprintf(stderr, "\033[2J%s\n", getenv("SECRET") ? "known" : "hidden");
    if (getenv("NEVER")) matrix_zero(NULL); else exit(getenv("NO") ? MIDPOINT.n : 2);'
spoil stdio stdlib >"class/=1+1/$slug.c"
printf 'int main(void) { return x; }\n' >"class/..dots/$slug.c"

# ---- the table ----------------------------------------------------------------
cat >wanted <<END
student,lesson,verdict,check,slot,mistake
'-dash,$slug,UNFINISHED,known_values_move_to_the_right,3a,-
..dots,$slug,WRONG,compile,-,-
'=1+1,$slug,CRASHED,known_values_move_to_the_right,3a,-
"Mallory ",$slug,CRASHED,known_values_move_to_the_right,3a,-
"O'Neill, ""Sean""",$slug,WRONG,known_values_move_to_the_right,3a,lift_sign
Zo$(printf '\303\253'),$slug,OK,-,-,-
ann,$slug,WRONG,known_values_move_to_the_right,3a,lift_sign
bob,$slug,WRONG,known_values_move_to_the_right,3a,lift_sign
eve,$slug,WRONG,compile,-,-
fay,$slug,WRONG,compile,-,-
gil,$slug,OK,-,-,-
ivy,$slug,WRONG,reactions_balance_the_loads,3c,reaction_sign
two twice,$slug,two files,-,-,-
w\\t(log),$slug,WRONG,compile,-,-
END
cat >marked <<END
student,$slug (of 4),missing
ann,0,"03: slot 3a, slot 3b, slot 3c, the whole"
gil,4,
ivy,2,"03: slot 3c, the whole"
nobody,,03: no file
two twice,,03: two files
'=1+1,0,"03: slot 3a, slot 3b, slot 3c, the whole"
END
"$MAKE" "mistakes-${slug%%_*}" >said 2>&1 # their judges are not copied
state >before
said=$(SECRET=1 "$MAKE" grade BUILD=build DIR=class 2>&1)
result $? 'grade judges a class' "$said"
grep -Fxf marked build/grade/marks.csv | sort >found
sort marked | cmp -s - found && [ "$(wc -l <build/grade/marks.csv)" = 16 ]
result $? 'grade writes the marks of a class' "$(cat build/grade/marks.csv)"
grep -q 'hidden' build/grade/verdicts.txt
result $? "a submission does not see the teacher's variables" \
    "$(cat build/grade/verdicts.txt)"
! grep -q "$(printf '\033')" build/grade/verdicts.txt
result $? 'no escape character of a submission is kept' "$said"
cmp -s wanted build/grade/grades.csv
result $? 'grade writes the table of a class' "$(diff wanted build/grade/grades.csv)"
for text in '</svg>' '03 lift sign' '03 slot 3a not written' '>files with it<'; do
    grep -qF "$text" build/grade/grades.svg
    result $? "grade draws: $text" "$(ls build/grade)"
done
for text in "known mistake (lift_sign)" "== two twice, $slug" 'is in UTF-16' \
    'not judged: it includes what is no header' \
    'Headers that no lesson needs: signal.h, unistd.h' \
    'the library that the solution does without: matrix_zero, MIDPOINT' \
    "aside: gil/$slug.c, two twice/$slug.c, solutions/$slug.c"; do
    grep -qF "$text" build/grade/verdicts.txt
    result $? "grade keeps what was said: $text" "$(cat build/grade/verdicts.txt)"
done
for text in '99_nothing.c: no lesson' 'twice/link: a link' 'everyone: a link' \
    "a.txt: in no student's folder" 'a?b: a name with control' \
    'nobody: nothing to judge' 'another file of this lesson' '3  03 lift sign' \
    "  eve/$slug-2.c, w\\t(log)/$slug.c" \
    "  O'Neill, \"Sean\"/handed in/$slug.c, ann/$slug (1).c, bob/$slug.c"; do
    printf '%s\n' "$said" | grep -qF "$text"
    result $? "grade says: $text" "$said"
done
[ "$(ls build/grade | tr '\n' ' ')" = 'grades.csv grades.svg marks.csv verdicts.json verdicts.txt ' ]
result $? 'grade leaves its tables and no folder' "$(ls build/grade)"
left=$(state | diff before -)
result $? 'a submission changes nothing' "$left"
said=$(FENCE= "$MAKE" grade BUILD=build DIR="$PWD/class/" FORMAT=gradescope 2>&1)
cmp -s wanted build/grade/grades.csv && echo "$said" | grep -q 'no bubblewrap'
result $? 'without a fence the class has the same table' "$said$(cat build/grade/grades.csv)"

# ---- for machines -------------------------------------------------------------
follows() { # follows SCHEMA FILE
    if python3 -c 'import jsonschema' 2>/dev/null; then
        wrong=$(python3 tests/tools/schema.py "$1" "$2" 2>&1)
        result $? "$2 keeps to its schema" "$wrong"
    else
        echo 'skip grade: no python3-jsonschema here'
    fi
}
{ echo '{"type": "array", "items":'
  cat tests/cli/verdict.schema.json
  echo '}'; } >list
follows list build/grade/verdicts.json
[ "$(grep -c '"student"' build/grade/verdicts.json)" = 14 ]
result $? 'verdicts.json has all files' "$(cat build/grade/verdicts.json)"
score() { # score STUDENT POINTS: each of 3 slots and the whole gives one
    file=build/grade/gradescope/$1/results.json
    follows tests/cli/gradescope.schema.json "$file"
    [ "$(sed -n 's/^  "score": \(.*\),$/\1/p' "$file")" = "$2" ] &&
        [ "$(grep -c '"max_score": 1,' "$file")" = 4 ]
    result $? "grade gives '$1' $2 of 4 points" "$(cat "$file")"
}
score gil 4
score bob 0
score ivy 2
score -dash 0
score 'Mallory ' 0
score "O'Neill, \"Sean\"" 0
score fay 0
score 'two twice' 0
mkdir none
said=$("$MAKE" grade BUILD=build DIR=class FORMAT=canvas 2>&1)
[ $? = 2 ] && echo "$said" | grep -q '^grade: FORMAT=canvas'
result $? 'grade refuses a FORMAT that it does not know' "$said"
for dir in '' no-such-folder none . ; do
    said=$("$MAKE" grade BUILD=build DIR="$dir" 2>&1)
    [ $? = 2 ] && echo "$said" | grep -q '^grade: ' &&
        cmp -s wanted build/grade/grades.csv
    result $? "grade refuses the folder '$dir'" "$said"
done
# where nothing confines bob he spoils ann's row and file, a mode and a time
mkdir -p open/ann open/bob open/cy
variant lift_sign | tee "open/ann/$slug.c" >"open/cy/$slug.c"
hostile='chmod("HERE/solutions/SLUG.c", 0600);
    utimensat(AT_FDCWD, "HERE/common/linear/matrix.h", (struct timespec[2]){0}, 0);
    FILE *f = fopen("../../../0001.SLUG/row", "w");
    if (f) fputs("ann\tSLUG\tOK\t-\t-\t-\n", f), fclose(f);
    if (system("cat HERE/solutions/SLUG.c >../../../0003.SLUG/SLUG.c")) {}'
spoil fcntl sys/stat stdio stdlib unistd >"open/bob/$slug.c"
rm build/tests/checks/confine.o
open() {
    "$MAKE" "$@" BUILD=build ANY_FLAGS=1 CFLAGS='-O0 -DWITHOUT_LANDLOCK' 2>&1
}
open build/tests/checks/confine.o "build/solutions/$slug.judge" "mistakes-${slug%%_*}" >said
state >before
for FENCE in bwrap ''; do
    export FENCE
    said=$(open grade DIR=open)
    status=$?
    [ "$(grep -c ',lift_sign$' build/grade/grades.csv)" = 2 ]
    result $? "others' rows and files are out of reach, fence '$FENCE'" "$said"
    [ "$FENCE" ] || { [ $status = 2 ] && grep -q '^bob.*not judged' build/grade/grades.csv; }
    result $? "who changes a mode, a time or a row is named, fence '$FENCE'" "$said"
    left=$(state | diff before -)
    result $? "what was changed is put back, fence '$FENCE'" "$left"
done
unset FENCE
# a compiler that is not done with a submission
mkdir -p late/ann && cp "solutions/$slug.c" late/ann
printf '#!/bin/sh\ncase $* in *build/grade/*) sleep 1000 ;; esac\nexec %s "$@"\n' \
    "${CC:-cc}" >never && chmod +x never
said=$(SECONDS_COMPILING=3 "$MAKE" grade BUILD=build DIR=late CC="$PWD/never" \
    ANY_FLAGS=1 2>&1)
[ $? = 2 ] && grep -q "^ann,$slug,not judged,-,-,-\$" build/grade/grades.csv &&
    grep -q 'the compiler was not done after 3 s' build/grade/verdicts.txt
result $? 'grade has no verdict where the compiler was not done' \
    "$said $(cat build/grade/grades.csv build/grade/verdicts.txt)"
# the lines for Gradescope of TEACHING.md, with a lesson and with none
awk '/^```/ { shown = 0 } shown { print } /^```sh/ { shown = 1 }' \
    lessons/TEACHING.md | sed "s|/autograder|\$PWD/autograder|" >run_autograder
mkdir -p autograder/source autograder/results autograder/submission
cp "solutions/$slug.c" autograder/submission
ln -s "$PWD" autograder/source/workbook
for points in 4 0; do
    BUILD=build sh run_autograder >said 2>&1
    grep -q "^.*\"score\": $points," autograder/results/results.json
    result $? "TEACHING.md grades for Gradescope: $points" \
        "$(cat said autograder/results/results.json)"
    rm -f autograder/submission/*
done
cd - >/dev/null && rm -rf "$copy"
