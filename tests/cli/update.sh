#!/bin/sh
# update.sh - make update in small copies of the workbook, of two lessons, which
# follow another: what becomes of a student's file in each change of a starter, and
# that nothing is lost whatever ends it; then make check, which judges what changed.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
top=$PWD work=$BUILD/test/update
rm -rf "$work" && mkdir -p "$work" && work=$(cd "$work" && pwd) || exit 1
slug=03_dirichlet_correction
file=lessons/$slug.c solution=solutions/$slug.c
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok update: $2"; else echo "FAIL update: $2: $3"; fi
}
GIT_CONFIG_NOSYSTEM=1 HOME=$work GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a
GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a GIT_CEILING_DIRECTORIES=$work
export GIT_CONFIG_NOSYSTEM HOME GIT_AUTHOR_NAME GIT_AUTHOR_EMAIL GIT_COMMITTER_NAME \
    GIT_COMMITTER_EMAIL GIT_CEILING_DIRECTORIES

# ---- two versions, and a student ----------------------------------------------
starter() { awk -f tests/tools/starter.awk "solutions/$1.c"; }
starters() { for s in solutions/*.c; do
    s=$(basename "$s" .c) && starter "$s" >"lessons/$s.c"; done; }
mine() { # of a starter on stdin: a slot and a prediction written
    awk '/^ \* PREDICT 1 / { sub(/\.\.\.$/, "238.5") }
        /todo\("3a"/ { print "    b[0] = A[0]; /* mine */"; next } { print }'
}
outside() { # and lines outside of the slots
    awk '{ print } /^#include <stdlib.h>/ { print "#include <math.h>" }
        /^static void print_matrix/ { inside = 1 }
        inside && /^}/ { print "\n/* helper */\nstatic double twice(double x) { return 2.0 * x; }"; inside = 0 }'
}
mkdir "$work/up" && cp -R Makefile .gitignore "$work/up" &&
    mkdir -p "$work/up/solutions" "$work/up/lessons/scenes" "$work/up/tests/tools" &&
    cp tests/tools/update.* tests/tools/starter.awk "$work/up/tests/tools" &&
    cp solutions/0[34]*.c "$work/up/solutions" && cd "$work/up" || exit 1
starters
git=$(command -v git)
if [ -n "$git" ]; then
    git init -q . 2>/dev/null && git checkout -q -b main && git add . &&
        git commit -q -m one && git tag one && git clone -q . ../old || exit 1
else
    echo 'skip update: no git here'
    cp -R . ../old
fi
cd ../old && mine <"$file" >../m && cat ../m >"$file" && cd ..

header() { sed 's/^ \* Run  */&first /' $solution >x && mv x $solution; }
contract() { sed 's/given A and g, change b;/given A, b and g, change b;/' \
    $solution >x && mv x $solution; }
# version EDIT...: the old tree, and the new version, with each edit
version() {
    rm -rf tree new && cp -Rp old tree && cp -Rp up new && cd new || exit 1
    for edit in "$@"; do $edit; done
    starters
    [ -z "$git" ] || { git add -A . && git commit -q --allow-empty -m two &&
        git tag two &&
        git -C ../tree remote set-url origin "$work/new"; }
    [ ! -f $file ] || mine <$file >../expected
    cd ../tree || exit 1
}
update() { # update WORDS...: what it says, and its status
    script=tests/tools/update.sh
    [ -f $script ] || script=$(echo saved/*/old/$script) # as the Makefile has it
    said=$(env FROM= DRY= "$@" sh "$script" 2>&1)
    status=$?
}
kept() { # the student's old file is in saved/
    for copy in saved/$slug.*.c; do cmp -s "$copy" ../mine && return; done
    return 1
}
is() { # is STATUS FILE WHAT [TEXT]: the student's file is that; his old one is kept
    cmp -s "$2" $file && [ $status = "$1" ] && echo "$said" | grep -q -e "${4:-.}" &&
        kept && [ ! -d saved/*.unfinished ]
    result $? "$3" "status $status: $said"
    cd "$work" || exit 1
}
# all that counts: the files, and where git stands
sums() {
    find . -name .git -prune -o -type f -exec cksum {} + | sort
    [ ! -d .git ] || git rev-parse HEAD
}
same() { # same WHAT TEXT: it ends with 2, says why, and nothing is changed
    [ $status = 2 ] && echo "$said" | grep -q -e "$2" && sums | cmp -s - ../sums
    result $? "$1: it says so, and nothing is changed" "status $status: $said"
    cd "$work" || exit 1
}
student() { $1 <$file >../m && cat ../m >$file && cp $file ../mine; }

# ---- what becomes of a file -----------------------------------------------------
if [ -n "$git" ]; then
version header && student cat
update
is 0 ../expected 'a line of the header that changed beside a prediction' \
    'set in: PREDICT 1, slot 3a'
version header contract && student cat
update
is 0 ../expected 'a contract that changed' 'contract of slot 3a has changed: read it'
question() { sed 's/sum of the reactions under/the sum under/' $solution >x && mv x $solution; }
version question && student cat
update
is 0 ../expected 'a question that changed' 'question of PREDICT 1 has changed: read it'
removed() { sed '/SLOT 3a/,/\*\//d; /END 3a/d' $solution >x && mv x $solution; }
version removed && student cat
update
is 1 ../expected 'a slot that is gone' "slot 3a is gone; yours is in saved/$slug"
version header && student outside && outside <../expected >../m
update
is 0 ../m 'lines outside of slots' 'set in: your lines outside'
collides() { sed 's/^#include <stdlib.h>/&\n#include <stdio.h>/' $solution |
    awk '/^static void print_matrix/ { inside = 1 } { print }
        inside && /^}/ { print "\nint other;"; inside = 0 }' >x && mv x $solution; }
version collides && student outside
update
is 1 ../expected 'lines outside of slots where the starter changed, too' \
    "your lines outside of slots do not fit; yours is in saved/$slug"
unix() { awk '{ printf "%s%s\r\n", (NR == 1 ? "\357\273\277" : ""), $0 }'; }
version header && student unix
update
is 0 ../expected 'line ends and the mark of another system'
version && student unix
update
is 0 ../mine 'a starter that has not changed'
indent() { sed 's/^    /\t/'; }
version header && student indent && mine <../new/$file | awk '/mine/ { sub(/^    /, "\t") } { print }' >../m
update
is 0 ../m 'blanks that an editor changed'
no_end() { grep -v 'END 3a'; }
version header && student no_end && no_end <../expected >../m
update
is 0 ../m 'a slot whose end is gone' 'set in: your lines outside'

renamed() { for f in solutions lessons; do mv $f/$slug.c $f/03_prescribed.c; done; }
version renamed && student cat && mine <../new/lessons/03_prescribed.c >../expected
update
[ ! -f $file ] && file=lessons/03_prescribed.c
is 0 ../expected 'a lesson with another name' 'is 03_prescribed now'
file=lessons/$slug.c
version contract renamed && student cat
sed '/^ . PREDICT 1/s/\.\.\.$/238.5/' ../new/lessons/03_prescribed.c >../expected
update
[ ! -f $file ] && file=lessons/03_prescribed.c
is 1 ../expected 'another name, and another contract' \
    "slot 3a asks for something else; yours is in saved/$slug"
file=lessons/$slug.c
gone() { rm solutions/$slug.c lessons/$slug.c; }
version gone && student cat
update
[ $status = 1 ] && echo "$said" | grep -q "$slug is gone; yours is in saved" &&
    [ ! -f $file ] && kept
result $? 'a lesson that is gone is kept, and named' "$said"
cd "$work" || exit 1

# ---- git in other states ----------------------------------------------------------
elsewhere() { echo '# new' >>Makefile; }
version header && student cat && echo '# own' >>Makefile
update
grep -q '^# own' Makefile && [ -n "$(git diff --name-only HEAD -- Makefile)" ]
result $? 'what else was changed here stays' "$said"
is 0 ../expected 'a file of mine beside other changes'
version header elsewhere && student cat && echo '# own' >>Makefile && sums >../sums
update
same 'a file that is changed here and there' '^Makefile$'
added() { echo new >added.md; }
version header added && student cat && echo own >added.md
update
[ "$(cat added.md)" = own ] && cmp -s ../mine $file && ! grep -q first $solution
result $? 'a file of mine where the new version has one' "$said"
is 2 ../mine 'and the version is not taken' 'your lessons are as they were'
version header && student cat && sums >../sums && git remote set-url origin "$work/nowhere"
update
same 'no network' 'cannot be fetched; nothing has changed'
version header && student cat && git checkout -q --detach && sums >../sums
update
same 'no branch' 'say FROM='
cd tree && git remote set-url origin "$work/new"
update FROM=two
is 0 ../expected 'a tag, where there is no branch' 'is two'
cd tree && sums >../sums
update FROM=three
same 'no such tag' 'no name that git knows'
cd tree
update FROM=one
[ $status = 0 ] && [ "$said" = 'This is the newest version.' ] && cmp -s ../expected $file
result $? 'nothing new changes nothing' "$said"
cd ..
version header && student cat && sums >../sums
update DRY=yes
[ $status = 0 ] && sums | cmp -s - ../sums && [ ! -d saved ] &&
    [ -z "$(git worktree list | sed 1d)" ]
result $? 'DRY=yes changes nothing' "$said"
dry=$(echo "$said" | sed 1d)
update
[ "$(echo "$said" | sed '$d')" = "$dry" ]
result $? 'and says what happens then' "$dry / $said"
is 0 ../expected 'and it does'
cd tree && sums >../sums
update DRY=1
same 'DRY=1' 'DRY=yes'

# ---- commits of one's own ---------------------------------------------------------
committed() { student cat && git commit -q -a -m mine && echo '/* later */' >>$file &&
    cp $file ../mine && cat ../expected >../m && echo '/* later */' >>../m; }
version header elsewhere && committed
update
[ "$(git log --format=%p -n 1 | wc -w)" -eq 2 ] && git merge-base --is-ancestor two HEAD &&
    [ -z "$(git status --short)" ] && grep -q '^# new' Makefile
result $? 'commits of mine are merged with the new ones' "$(git status --short) $said"
is 0 ../m 'a lesson that I have committed'
version header elsewhere && committed && sed '1s/^/# own /' Makefile >x && mv x Makefile &&
    sed '$d' Makefile >x && mv x Makefile && git commit -q -a -m own && sums >../sums
update
same 'a conflict elsewhere' 'Makefile'
version gone && committed
update
[ $status = 1 ] && [ ! -f $file ] && [ -z "$(git status --short)" ] &&
    kept
result $? 'a lesson that I have committed and that is gone' "$(git status --short) $said"
cd "$work" || exit 1
version renamed && committed && mine <../new/lessons/03_prescribed.c >../m &&
    echo '/* later */' >>../m
update
[ ! -f $file ] && [ -z "$(git status --short)" ] && file=lessons/03_prescribed.c
is 0 ../m 'a lesson that I have committed and that has another name'
file=lessons/$slug.c
version header && committed && git update-ref MERGE_HEAD one && sums >../sums
update
same 'a merge that is under way' 'a merge is under way'
version header && cp ../expected ../new/$file && git -C ../new commit -q -a -m pushed &&
    student cat && sums >../sums
update
same 'a lesson that is written on the branch' "has work in $file: commit yours, and git pull"
fi

# ---- a folder or an archive ---------------------------------------------------------
moved() { git mv solutions/04_*.c solutions/04_flux.c 2>/dev/null || mv solutions/04_*.c solutions/04_flux.c
    rm lessons/04_*.c; }
without_git() {
    version header moved && student cat && rm -rf .git ../new/.git && rm -f ../new/x &&
        mkdir -p lessons/scenes && echo 'width 1' >lessons/scenes/mine.scene && mine <../new/$file >../expected
}
for from in folder archive; do
    without_git
    from_where=../new
    if [ $from = archive ]; then
        cp -R ../new ../workbook-2 && tar -C .. -cf - workbook-2 | gzip >../new.tgz
        rm -rf ../workbook-2
        from_where=../new.tgz
    else # in which somebody has worked
        echo '/* of somebody else */' >>../new/$file
    fi
    sums >../sums
    update FROM=$from_where DRY=yes
    [ $status = 0 ] && sums | cmp -s - ../sums && [ ! -d saved ]
    result $? "DRY=yes of a $from changes nothing" "$said"
    touch ../before && sleep 1
    update FROM=$from_where
    [ ! -f lessons/04_neumann_compatibility.c ] && [ -f solutions/04_flux.c ] &&
        starter 04_flux | cmp -s - lessons/04_flux.c &&
        [ -f lessons/scenes/mine.scene ] && [ -d saved/old.*/tests/tools ] &&
        [ -z "$(find solutions tests Makefile ! -type d ! -newer ../before)" ]
    result $? "a $from: what is gone is gone, mine stays, all is newer than what is built" "$said"
    is 0 ../expected "a $from"
done
without_git && sums >../sums
update
same 'no git, and no FROM' 'say FROM='
cd tree
update FROM=lessons
same 'a folder that is no workbook' 'is no workbook'
cd tree
update FROM=$file
same 'a file that is no archive' 'cannot be unpacked'
mkdir tools
echo "$PATH" | tr : '\n' | while IFS= read -r folder; do
    ln -s "$folder"/* tools 2>/dev/null
done
rm -f tools/git
if [ -e tools/diff3 ]; then
    without_git && student outside && outside <../expected >../m
    PATH=$work/tools update FROM=../new
    is 0 ../m 'lines outside of slots, without git'
    rm tools/diff3
fi
without_git && student outside
PATH=$work/tools update FROM=../new
is 1 ../expected 'lines outside of slots where nothing can merge' 'do not fit'

# ---- ends in the middle ---------------------------------------------------------------
# The programs that change something are replaced by ones of which the one that is
# called as the Nth fails, or kills the script before it does anything.
mkdir tools/ending && for name in cp mv git; do
    real=$(command -v $name) || continue
    cat >tools/ending/$name <<END
#!/bin/sh
case $name\$1 in gitcheckout|gitmerge|gitworktree|git-C|[!g]*) ;; *) exec $real "\$@" ;; esac
echo >>$work/calls
[ \$(wc -l <$work/calls) -ne \$N ] || {
    [ \$HOW = fails ] || kill -9 \$(cat $work/victim)
    exit 1
}
exec $real "\$@"
END
    chmod +x tools/ending/$name
done
sweep() { # sweep WHAT PREPARE FROM HOW...
    $2
    cd .. && rm -rf ready && mv tree ready
    what=$1 from=$3
    shift 3
    for HOW in "$@"; do
        N=0 lost=
        while :; do
            N=$((N + 1))
            rm -rf tree && cp -Rp ready tree && cd tree && : >../calls
            PATH=$work/tools/ending:$PATH N=$N HOW=$HOW FROM=$from DRY='' \
                sh -c 'echo $$ >../victim; exec sh tests/tools/update.sh' >../said 2>&1
            [ "$(wc -l <../calls)" -ge $N ] || break
            find . -name "$slug*" -type f -exec cmp -s ../mine {} \; -print |
                grep -q . || lost="$lost $N: mine is nowhere;"
            cp ../expected ../due
            ! cmp -s ../due $file || # mine is back: and is edited
                for f in ../due $file; do echo '/* edited */' >>$f; done
            update FROM="$from"
            cmp -s ../due $file && kept && [ ! -d saved/*.unfinished ] ||
                lost="$lost $N: $(cat ../said) / $said;"
            cd "$work" || exit 1
        done
        cd "$work" || exit 1
        [ -z "$lost" ] && [ $N -gt 10 ]
        result $? "$what: the next one ends what $HOW in any of $((N - 1)) places" "$lost"
    done
}
with_git() { version header && student cat; }
with_commits() { version header && committed && cp ../m ../expected; }
[ -z "$git" ] || sweep git with_git '' fails # a commit of one's own has all places
[ -z "$git" ] || sweep 'commits of mine' with_commits '' killed
sweep 'a folder' without_git ../new fails killed

# ---- make check, in a copy of the workbook ---------------------------------------------
version contract header
cd "$top" && BUILD="$BUILD" sh tests/tools/copy.sh "$work/copy" $slug && cd "$work/copy" || exit 1
starters
check() { # check STATUS TEXT WHAT [MAKE]: of make check; TEXT is its last line
    said=$(env BUILD=build MAKE="${4:-$MAKE}" sh tests/tools/student.sh check 2>&1)
    status=$?
    [ $status = "$1" ] && echo "$said" | tail -n 1 | grep -qx -e " *$2"
    result $? "make check: $3" "status $status: $said"
}
judged() { # judged yes|no
    [ "$(echo "$said" | grep -c '^VERDICT 03')" = "$([ "$1" = yes ] && echo 1 || echo 0)" ]
    result $? "make check: judged $1" "$said"
}
check 0 'You have not begun.*' 'nothing is begun'
mine <$file >m && mv m $file
check 1 "$slug  *WRONG  *known_values_move_to_the_right (slot 3a)" 'a lesson that is begun'
judged yes
check 1 "$slug  *WRONG  *known_values_move_to_the_right (slot 3a)" 'and is as it was'
judged no
cp $solution $file
check 0 "$slug  *OK" 'a lesson that has changed'
judged yes
said=$("$MAKE" check 2>&1)
result $? 'make check: a lesson that has passed' "$said"
judged no
for changed in tests/checks/$slug.c tests/checks/judge.c $solution; do
    cp -p $changed before && echo '/* new */' >>$changed
    said=$("$MAKE" status)
    echo "$said" | grep -q "$slug  *judge again: lesson changed" &&
        ! "$MAKE" solution-03 >/dev/null 2>&1
    result $? "a pass is none when $changed has changed" "$said"
    mv before $changed
done
echo '/* edited */' >>$file
check 2 "$slug  *not judged" 'what cannot be judged' false
starter $slug | mine >$file
said=$("$MAKE" update FROM=../new DRY=yes 2>&1)
[ $? = 0 ] && echo "$said" | grep -q 'set in: PREDICT 1, slot 3a' &&
    echo "$said" | grep -q 'contract of slot 3a has changed: read it'
result $? 'make update FROM=../new DRY=yes' "$said"
cd "$top" && rm -rf "$work"
