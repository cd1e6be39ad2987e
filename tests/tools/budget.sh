#!/bin/sh
# budget.sh table|lint - how much there is in each room, against tests/budget.txt.
#
# A budget may fall at any time.  It rises only with a line in CHANGELOG.md that says
# why: "budget N UNIT FILES: reason", with N, UNIT and FILES as in tests/budget.txt.
# table also names what is long: a file above 450 lines, a function above 60.  That is
# a warning, and no more.
set -u
LC_ALL=C
export LC_ALL
written() { # what somebody wrote: no comments, no rows or links that are filled in
    awk '/^ *<!-- (table|labels|seconds (step|rivals))/ { filled = 1; next }
        /^ *<!-- (seconds )?end -->/ { filled = 0; next }
        filled && (!/^[|]/ || filled++ > 1) { next }
        { gsub(/<!--[^>]*-->/, ""); print }'
}
room() { # room FILES UNIT: how much there is
    # shellcheck disable=SC2086
    cat $1 2>/dev/null | case $2 in words) written | wc -w ;; *) wc -l ;; esac | tr -d ' '
}
grep '^[0-9]' tests/budget.txt | while read -r most unit files; do
    now=$(room "$files" "$unit")
    if [ "$1" = table ]; then
        printf '  %7d of %7d %s  %s\n' "$now" "$most" "$unit" "$files"
        continue
    fi
    # the last number that CHANGELOG.md gives this room
    said=$(grep -F " $unit $files:" CHANGELOG.md | grep -o 'budget [0-9]*' |
        tail -n 1 | tr -dc 0-9)
    if [ "$now" -gt "$most" ]; then
        echo "FAIL lint: budget of $files: $now $unit, $most are allowed: leave something" \
            'out, or raise it in tests/budget.txt and say why in CHANGELOG.md'
    elif [ "$most" -gt "${said:-0}" ]; then
        echo "FAIL lint: budget of $files: $most is more than the ${said:-0} of" \
            "CHANGELOG.md, which needs a line: budget $most $unit $files: why"
    else
        echo "ok lint: budget of $files"
    fi
done
[ "$1" = table ] || exit 0
# checks and laws are lists, and may be as long as they are
wc -l Makefile tests/*.mk common/*/*.[ch] lessons/choose/* solutions/*.c figures/*/*.[ch] \
    tests/checks/[a-z]*.[ch] tests/tools/*.* tests/cli/* |
    awk '$1 > 450 && $2 != "total" { print "  long: " $2 ", " $1 " lines" }'
awk 'FNR == 1 { start = 0 }
    !start && /^[a-z_].*[(]/ && !/;$/ { start = NR; name = $0; body = 0 }
    /^\{/ || / = \{$/ { body = 1 }
    start && !body && /;$/ { start = 0 } # a declaration
    /^}/ { if (start && NR - start + 1 > 60)
               print "  long: " FILENAME ", " NR - start + 1 " lines: " name
           start = 0 }' common/*/*.c lessons/choose/*.c solutions/*.c figures/*/*.c tests/*/*.c
