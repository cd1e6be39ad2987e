#!/bin/sh
# limits.sh - `make lesson-03` and `make plot-03` end a program that does not end
# by itself, and two makes at once do not spoil each other's files.  Prints "ok
# ...", "FAIL ..." or "skip ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
slug=03_dirichlet_correction nn=03
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok cli: $2"; else echo "FAIL cli: $2: $3"; fi
}
copy=$BUILD/test/copy.limits
BUILD="$BUILD" sh tests/tools/copy.sh "$copy" $slug || exit 1
cd "$copy" || exit 1

# ---- limits ---------------------------------------------------------------------
# The loop shortens the limit that it finds, and without one there is no loop.
loop='struct rlimit is;
    if (getrlimit(RLIMIT_CPU, &is) || is.rlim_cur > 20) exit(0);
    is.rlim_cur = 1;
    setrlimit(RLIMIT_CPU, &is);
    for (volatile int spin = 0;; spin = 1) {}'
print='for (int k = 0; k < 12000000; k++) puts("and on and on");'
with_line() { # with_line LINE: the solution with LINE in its first slot
    echo '#include <stdlib.h>'
    echo '#include <sys/resource.h>'
    line=$1 awk '{ print }
        !done && /\/\* SLOT / { inside = 1 }
        inside && /\*\// { print ENVIRON["line"]; inside = 0; done = 1 }' \
        "solutions/$slug.c"
}
for shell in dash bash 'busybox sh'; do
    program=$(command -v "${shell%% *}") || {
        echo "skip cli: no $shell here"
        continue
    }
    mkdir -p "$shell" && printf '#!/bin/sh\nexec %s "$@"\n' \
        "$program${shell#"${shell%% *}"}" >"$shell/sh" && chmod +x "$shell/sh"
    for kind in loop print; do
        eval "with_line \"\$$kind\"" >"lessons/$slug.c"
        ended='computes for too long'
        [ $kind = loop ] || ended='prints too much'
        for goal in lesson plot; do
            said=$(PATH=$PWD/$shell:$PATH "$MAKE" $goal-$nn 2>&1)
            status=$?
            [ $status != 0 ] && echo "$said" | grep -qF "$ended" &&
                [ "$(wc -c <build/mine/$slug.tsv)" -le 68000000 ]
            result $? "$goal in $shell ends an endless $kind" \
                "status $status, $(echo "$said" | tail -n 5)"
        done
        rm -f build/mine/$slug.tsv
    done
done

# ---- two makes at once ------------------------------------------------------------
# A program that takes its time, so that the one has not ended when the other
# begins: once, because the judge runs it five times and ends what computes nothing
# for five seconds in all.
picture=figures/$slug/conditioning.svg
mv build/solutions/$slug build/solutions/quick
printf '#!/bin/sh\n[ $# != 0 ] || sleep 1\nexec "${0%%/*}/quick" "$@"\n' \
    >build/solutions/$slug
chmod +x build/solutions/$slug
cp "$picture" before.svg
rm -f build/data/$slug.tsv build/mistakes/$slug/*
for k in 1 2; do
    "$MAKE" -j2 build/data/$slug.tsv "$picture" build/test/$slug.solution.result \
        build/mistakes/$slug/all.judge >said.$k 2>&1 &
    eval "run$k=\$!"
done
wait "$run1"
first=$?
wait "$run2"
second=$?
[ $first$second = 00 ]
result $? 'two makes at once end well' "status $first, $second: $(cat said.1 said.2)"
cmp -s before.svg "$picture" && [ -s build/mistakes/$slug/lift_sign.why ] &&
    [ -z "$(find . -name '*.part')" ]
result $? 'two makes at once make what one makes' \
    "$(cmp before.svg "$picture"; find . -name '*.part')"
cd - >/dev/null && rm -rf "$copy"
