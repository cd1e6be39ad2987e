#!/bin/sh
# sizes.sh table|lint - how long the files are, against what is allowed.
#
# table prints the figures; lint prints lines "ok lint: ..." or "FAIL lint: ...".
# Lessons stay small: an experiment has its room in figures/, and the library
# its room in common/.
set -u
LC_ALL=C
export LC_ALL
lines() { # lines FILES: "lines file" of each that exists
    for f in "$@"; do [ -f "$f" ] && echo "$(($(wc -l <"$f"))) $f"; done
}
starters() { # what the student gets, whatever stands in lessons/ now
    for f in solutions/[0-9][0-9]_*.c; do
        echo "$(($(awk -f tests/tools/starter.awk "$f" | wc -l))) lessons/${f##*/}"
    done
}
# row WHAT MEDIAN-ALLOWED LARGEST-ALLOWED, of lines "size file" on stdin
row() {
    sort -n | awk -v what="$1" -v middle="$2" -v most="$3" -v mode="$mode" '
        { size[NR] = $1; file[NR] = $2 }
        END {
            if (NR == 0) exit
            median = size[int((NR + 1) / 2)]
            if (mode == "table") {
                printf "  %-34s %5d %8d %9d   allowed %s%d  %s\n", what, NR,
                    median, size[NR], (middle == "-" ? "" : middle " / "),
                    most, file[NR]
                exit
            }
            bad = ""
            if (middle != "-" && median > middle) bad = " median " median " of " middle
            for (i = 1; i <= NR; i++)
                if (size[i] > most) bad = bad " " file[i] " " size[i]
            print (bad == "" ? "ok" : "FAIL") " lint: " what ", at most " \
                (middle == "-" ? "" : middle " in the middle and ") most \
                (bad == "" ? "" : ":" bad)
        }'
}
mode=$1
[ "$mode" = lint ] || printf '  %-34s %5s %8s %9s\n' '' files median largest
# 24 is the longest; 10 and 12 have five slots, 07, 08 and 20 a struct to fill and
# free, 17 four slots of which one is a loop in a loop over vertex and component
few='/(07_poisson_bvp|08_element_assembly|10_neohookean_bar|12_triangles)\.c$'
few="$few|/(17_fibres|20_mpm_implicit|24_live)\.c\$"
lines $(ls solutions/*.c | grep -vE "$few") | row 'lines of a solution' - 250
lines $(ls solutions/*.c | grep -E "$few") | row 'lines of one of the long solutions' - 300
starters | row 'lines of a starter' - 240
shared() { # shared yes|no FILES: those that several studies share, or the others
    want=$1; shift
    for f in "$@"; do
        if [ -f "${f%c}h" ]; then [ "$want" = yes ] && echo "$f"
        else [ "$want" = no ] && echo "$f"; fi
    done
}
lines $(shared no figures/*/*.c | grep -vE '^figures/(speed|many)/') |
    row 'lines of a study' 100 160
lines $(shared no figures/speed/*.c) | row 'lines of a study of speed' - 190
lines figures/many/*.[ch] | row 'lines of the study with PETSc' - 250
lines common/*/*.[ch] $(shared yes figures/*/*.c) | row 'lines of a file of common/' - 420
lines lessons/web/*.* | row 'lines of a script of the pages' - 250
lines workbook.md | row 'lines of workbook.md' - 530
# a part of the judge, or a tool, does one thing; checks and laws are lists
lines $(ls tests/checks/*.[ch] | grep -v '/[0-9][0-9]_') tests/tools/*.* tests/cli/*.sh |
    row 'lines of a part of the judge or a tool' - 420
lines tests/checks/[0-9]*.c tests/unit/*.[ch] | row 'lines of checks or of unit laws' - 900
