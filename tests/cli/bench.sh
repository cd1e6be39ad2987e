#!/bin/sh
# bench.sh - what becomes of the tables that `make bench` measures: the closing
# table says met, missed and not there, and the chapter gets its tables of
# seconds, and nothing else changes in it.
#
# Prints "ok bench: ..." or "FAIL bench: ...".
set -u
LC_ALL=C
export LC_ALL
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
rule() { # rule NAME OFFENDERS
    [ -n "$2" ] || { echo "ok bench: $1"; return; }
    printf 'FAIL bench: %s: %s\n' "$1" "$2"
}
page=figures/speed/README.md
mkdir "$tmp/speed"
printf '# machine: made up\n\n\n# large\n# a note\nsolver\tn\tns_per_unknown
both\t1000000\t6.5\ngsl\t1000000\t40\n' >"$tmp/speed/chart.tsv"
printf '# machine: another\n\n\n# peer\n# PETSc 9.9\nmethod\tn\tstep_ms\tover_ours
notes\t8\t7\t7\nmethod\t8\t2\t2\n' >"$tmp/speed/peer.tsv"
printf '# machine: made up\n\n\n# steps\nmethod\tn\tmedian_ms
best\t8\t1.2345\nblocked\t8\t5.5\n' >"$tmp/speed/step.tsv"
printf '# machine: made up\n\n\n# solvers\nsolver\tn\tstep_ms
kept_single\t8\t0.5\n' >"$tmp/speed/solvers.tsv"
closing() {
    awk -v processor="$1" -f tests/tools/bench.awk -f tests/tools/closing.awk \
        "$tmp"/*/*.tsv
}
says() { closing "$1" | grep -q -- "$2" || echo "not '$2'"; }
rule 'a goal is met, missed or not measured' \
    "$(says 1 'n = 8  *>= 6  *7  yes$'
       says 1 'per unknown and iteration  *<= 6  *6.5  NO$'
       says 1 'same loop with GSL  *>= 5  *6.154  yes$'
       says 1 'LAPACK  *>= 1  *-  -$')"
rule 'a machine that was not quiet is named' \
    "$(says 0.97 '97 % .* was quiet'; says 0.5 '50 % .* NOT quiet')"
awk -f tests/tools/bench.awk -f tests/tools/seconds.awk "$tmp"/*/*.tsv "$page" \
    >"$tmp/page.md"
has() { grep -qF -- "$1" "$tmp/page.md" || echo "not '$1'"; }
rule 'the chapter gets what was measured, with its machine' \
    "$(has '| 8 | - | 1.23 | - | 0.500 |'
       has '| 8 | 3.5 | 2.0 | 7.0 |'
       has '*made up.*'
       has '*another; PETSc 9.9.*')"
without() { sed '/^<!-- seconds [a-z]* -->/,/^<!-- seconds end -->/d' "$1"; }
without "$page" >"$tmp/before"
without "$tmp/page.md" >"$tmp/after"
rule 'nothing else changes in the chapter' "$(diff "$tmp/before" "$tmp/after")"
awk -f tests/tools/bench.awk -f tests/tools/seconds.awk "$tmp"/*/*.tsv "$tmp/page.md" |
    cmp -s - "$tmp/page.md" || again=differs
rule 'a second time it is the same' "${again-}"
