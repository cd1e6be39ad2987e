#!/bin/sh
# update.sh - make update [FROM=WHAT] [DRY=yes]: take a new version of the workbook,
# and set what the student wrote into its starters.
#
# The new version is what this branch of git follows, or WHAT: a folder, an archive,
# or a commit by a name that git knows.  First all is worked out in a folder of
# saved/: NN_slug.c the student's files, from/ and to/ the starters of both
# versions, set/ what becomes of his files.  Then that folder is called
# *.unfinished, and only from here on anything else changes.  However it ends,
# settle() sees by the solutions which version a lesson has, and puts the file of
# that version into its place; if it could not, the next `make update` does.
set -u
LC_ALL=C
export LC_ALL
: "${FROM:=}" "${DRY:=}"
tools=tests/tools date=$(date +%Y%m%d-%H%M%S).$$ work= state= new=
stop() { echo "make update: $1" >&2; exit 2; }
full() { stop 'saved/ cannot be written; nothing has changed'; }

lessons() { (cd "$1/solutions" && ls [0-9][0-9]_*.c) | sed 's/\.c$//'; }
starter() { awk -f "$1/$tools/starter.awk" "$1/solutions/$2.c" | tr -d '\r'; }
is() { tr -d '\r' <"$1" | cmp -s - "$2"; }
alike() { # but for blanks and line ends
    [ "$(tr -d ' \t\n' <"$1" | cksum)" = "$(tr -d ' \t\n' <"$2" | cksum)" ]
}
merged() { # merged MINE OLD NEW: what changed in either; fails where both did
    if command -v git >/dev/null; then git merge-file -p "$@"; else diff3 -m "$@"; fi
} 2>/dev/null

# ---- what becomes of a file -------------------------------------------------

# carry SLUG: the student's file, as it is in the new version, to $work/set/
carry() {
    mine=lessons/$1.c old=$work/from/$1.c to=$1 strict= kept=saved/$1.$date.c
    starter . "$1" >"$old" || full
    [ -f "$mine" ] && ! is "$mine" "$old" || return 0
    cp "$mine" "$work/$1.c" && cmp -s "$mine" "$work/$1.c" || full
    if [ ! -f "$new/solutions/$1.c" ]; then # another name, with the same number?
        to=$(lessons "$new" | grep "^${1%%_*}_") strict=1
        [ "$to" ] || { echo "  $1 is gone; yours is in $kept"; return; }
    fi
    if [ "$commit" ] && git show "HEAD:$mine" >"$work/head/$1.c" 2>/dev/null; then
        is "$work/head/$1.c" "$old" || : >"$work/committed/$to"
    fi
    onto=$work/to/$to.c
    starter "$new" "$to" >"$onto" || full
    if [ "$to" = "$1" ] && cmp -s "$old" "$onto"; then
        cp "$mine" "$work/set/$1.c" || full
        return
    fi
    if [ "$to" = "$1" ]; then echo "  $1"; else echo "  $1 is $to now"; fi
    awk -f $tools/update.awk f=2 "$old" f=3 "$mine" >"$work/outside" || full
    if ! alike "$work/outside" "$old"; then # he changed more than his slots
        if merged "$work/outside" "$old" "$onto" >"$work/merged"; then
            onto=$work/merged
            echo '    set in: your lines outside of slots'
        else
            echo "    your lines outside of slots do not fit; yours is in $kept"
        fi
    fi
    : >"$work/said"
    awk -v strict="$strict" -v kept="$kept" -v report="$work/said" \
        -f $tools/update.awk f=1 "$old" f=2 "$mine" f=3 "$onto" \
        >"$work/set/$to.c" && cat "$work/said" || full
}

# edited FILE SLUG: the student has edited his file since an interrupt; it is
# neither FILE nor a starter nor what git had of it
edited() {
    [ -f "lessons/$2.c" ] && ! cmp -s "lessons/$2.c" "$1" || return
    for known in from to head; do
        known=$state/$known/$2.c
        [ ! -f "$known" ] || ! is "lessons/$2.c" "$known" || return
    done
}
# Put the files of the lessons into their places.
settle() {
    for file in "$state"/[0-9]*.c "$state"/set/*.c; do
        slug=$(basename "$file" .c) version=from
        case $file in */set/*) version=to ;; esac
        [ -f "$file" ] && [ -f "solutions/$slug.c" ] &&
            starter . "$slug" | cmp -s - "$state/$version/$slug.c" || continue
        mine=lessons/$slug.c
        if edited "$file" "$slug"; then
            echo "  $mine was edited since: it stays as it is"
        else
            cmp -s "$file" "$mine" || { cp "$file" "$mine.part" &&
                mv "$mine.part" "$mine"; } || return
        fi
    done
    for file in "$state"/[0-9]*.c; do
        [ ! -f "$file" ] || mv "$file" "saved/$(basename "$file" .c).$date.c" || return
    done
    [ ! -d "$state/old" ] || mv "$state/old" "saved/old.$date" || return
    rm -rf "$state"
}

# ---- git --------------------------------------------------------------------

find_commit() { # $commit: the new version
    [ -e .git ] || stop 'this is no clone of git; say FROM=, a folder or an archive'
    [ "$FROM" ] || git rev-parse -q --verify '@{upstream}' >/dev/null 2>&1 ||
        stop 'this follows no branch; say FROM=origin/main, or a tag, folder, archive'
    [ -z "$(git ls-files -u)" ] && ! git rev-parse -q --verify MERGE_HEAD >/dev/null ||
        stop 'a merge is under way; end it, or git merge --abort'
    git fetch -q ${FROM:+--all --tags} ||
        stop 'the new version cannot be fetched; nothing has changed'
    what=${FROM:-@\{upstream\}}
    commit=$(git rev-parse -q --verify "$what^{commit}") ||
        stop "FROM=$FROM is no folder, no archive, and no name that git knows"
    if git merge-base --is-ancestor "$commit" HEAD; then
        echo 'This is the newest version.'
        exit 0
    fi
    # a lesson that is no starter there is the student's, from another machine
    for file in $(git diff --name-only HEAD "$commit" -- 'lessons/[0-9]*.c'); do
        git show "$commit:$file" >"$work/theirs" 2>/dev/null || continue
        git show "$commit:solutions/${file#*/}" 2>/dev/null |
            awk -f $tools/starter.awk >"$work/starter"
        is "$work/theirs" "$work/starter" ||
            stop "the new version has work in $file: commit yours, and git pull"
    done
}

# $new: a second tree with the new version, or, where the student has commits of
# his own, with both.
grow() {
    new=$work/tree base=$commit
    git merge-base --is-ancestor HEAD "$commit" || base=HEAD
    git worktree add -q --detach "$new" $base || full
    if [ $base = HEAD ]; then
        (cd "$new" && git merge -q --no-commit --no-ff "$commit" >../said 2>&1
            for file in $(git diff --name-only --diff-filter=U -- 'lessons/[0-9]*.c'); do
                if [ -f "solutions/${file#*/}" ]; then
                    starter . "$(basename "$file" .c)" >"$file" && git add "$file"
                else
                    git rm -q -f "$file" >/dev/null
                fi
            done
            git rev-parse -q --verify MERGE_HEAD >/dev/null &&
                [ -z "$(git ls-files -u)" ]) || {
            cat "$work/said" >&2
            stop 'git cannot merge this with commits of yours; nothing has changed'
        }
    fi
    git -C "$new" diff --cached --name-only "$(git rev-parse HEAD)" >"$work/changing"
    git diff --name-only HEAD | grep -v '^lessons/[0-9][0-9]_[^/]*\.c$' |
        grep -xF -f "$work/changing" >"$work/said" || return 0
    cat "$work/said" >&2
    stop 'these are changed here, too; commit them, or git checkout them, first'
}

# The merge has those lessons that the student had committed, as they are now.
commit_merge() {
    if [ $base = HEAD ]; then
        for slug in $(ls "$work/committed"); do
            cp "$work/set/$slug.c" "$new/lessons/$slug.c" || full
        done
        git -C "$new" add lessons && git -C "$new" commit -q --no-edit &&
            commit=$(git -C "$new" rev-parse HEAD) ||
            stop 'git does not commit the merge; nothing has changed'
    fi
    rm -rf "$new"
    git worktree prune
}

take_commit() {
    set --
    for slug in $(lessons .); do
        ! git cat-file -e "HEAD:lessons/$slug.c" 2>/dev/null ||
            set -- "$@" "lessons/$slug.c"
    done
    git checkout -q HEAD -- "$@" && git merge -q --ff-only "$commit"
}

# ---- a folder, or an archive ------------------------------------------------

unpack() { # $new: a copy, whose files are newer than all that is built
    mkdir "$work/unpacked" || full
    if [ -d "$FROM" ]; then
        for entry in "$FROM"/* "$FROM"/.[!.]*; do
            case ${entry##*/} in .git | build | saved) continue ;; esac
            [ ! -e "$entry" ] || cp -R "$entry" "$work/unpacked" || full
        done
    else
        case $FROM in
        *.zip) unzip -q -DD "$FROM" -d "$work/unpacked" ;;
        *) (archive=$(cd "$(dirname "$FROM")" && pwd)/$(basename "$FROM")
            cd "$work/unpacked" && tar -xmf "$archive") ;;
        esac || stop "$FROM cannot be unpacked; nothing has changed"
    fi
    new=$work/unpacked
    [ -f "$new/$tools/starter.awk" ] || new=$(echo "$new"/*/$tools)
    new=${new%/"$tools"}
    [ -f "$new/$tools/starter.awk" ] && [ "$(lessons "$new")" ] &&
        [ -f "$new/Makefile" ] || stop "FROM=$FROM is no workbook; nothing has changed"
    mv "$new" "$work/new" && new=$work/new || full
    rm -rf "$new/.git" "$new/build" "$new/saved"
    for slug in $(lessons "$new"); do
        starter "$new" "$slug" >"$new/lessons/$slug.c" || full
    done
}

# Each entry of the new version takes the place of the old one, which is kept; and
# what the student added to lessons/ is added again.  It may begin in the middle.
swap() {
    mkdir -p "$state/old"
    for entry in "$state"/new/* "$state"/new/.[!.]*; do
        name=${entry##*/}
        [ -e "$entry" ] || continue
        if [ -f "$name" ]; then
            cp -p "$name" "$state/old/" || return
        elif [ -d "$name" ]; then
            mv "$name" "$state/old/" || return
        fi
        mv -f "$entry" . || return
    done
    [ ! -d "$state/old/lessons" ] || (cd "$state/old" && find lessons -type f) |
        while read -r file; do
            slug=${file##*/}
            [ -e "$file" ] || [ -f "$state/old/solutions/${slug%.*}.c" ] ||
                { mkdir -p "${file%/*}" && cp -p "$state/old/$file" "$file"; } || exit
        done
}

# ---- all of it --------------------------------------------------------------

finish() {
    [ -z "$state" ] || { { [ ! -d "$state/new" ] || swap; } && settle; } || {
        where=$state state=
        stop "this cannot be ended: see $where, where all is, and make update again"
    }
    state=
}
leave() {
    trap '' INT TERM HUP
    finish
    [ -z "$work" ] || rm -rf "$work"
    [ ! -e .git ] || git worktree prune 2>/dev/null
    rmdir saved 2>/dev/null
}
case $DRY in '' | yes) ;; *) stop 'DRY=yes says what would happen' ;; esac
trap leave EXIT
trap 'exit 130' INT TERM HUP
for state in saved/*.unfinished; do
    [ -d "$state" ] || continue
    [ -z "$DRY" ] || { state=; stop 'one was interrupted; make update ends that first'; }
    date=${state#saved/} date=${date%.unfinished}
    finish
    echo "An update was interrupted; it is settled (saved/NN_slug.$date.c are your files)."
done
state= date=$(date +%Y%m%d-%H%M%S).$$ commit=
mkdir -p saved && rm -rf saved/part.* && work=$(mktemp -d saved/part.XXXXXX) &&
    mkdir "$work/from" "$work/to" "$work/set" "$work/head" "$work/committed" || full
if [ -e "$FROM" ]; then unpack; else find_commit && grow; fi
for slug in $(lessons .); do carry "$slug"; done >"$work/report"
if [ "$DRY" ]; then
    echo 'make update would do this, and has changed nothing:'
elif [ "$commit" ]; then
    commit_merge
fi
echo "The new version is $([ -z "$commit" ] && echo "$FROM" ||
    git describe --always --tags "$commit").  Of yours:"
grep . "$work/report" || echo '  nothing changes'
! grep -q 'yours is in' "$work/report"
fits=$?
[ -z "$DRY" ] || exit $fits

state=saved/$date.unfinished
mv "$work" "$state" && work= || full
[ -z "$commit" ] || take_commit
taken=$?
finish
[ $taken = 0 ] || stop 'the new version was not taken (see above); your lessons are as they were'
echo "Done; your files of before are saved/NN_slug.$date.c.  next: make check"
exit $fits
