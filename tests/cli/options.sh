#!/bin/sh
# options.sh [SEED [LINES]] - random options for every solution, from its own -h.
#
# What -h allows is solved, or ends with status 1 and one reason; no cell is nan
# or inf.  Anything else is refused in one line.  What is a text, such as a file's
# name, is left alone.  Prints "ok ..." or "FAIL ...".
set -uf
export LC_ALL=C
: "${BUILD:=build}"
seed=${1:-2385} lines=${2:-25} tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT

random_lines() { # allowed or refused|what the message says|words...
    awk -v seed="$seed" -v lines="$lines" '
        function random(n) { # 0 to n - 1, the same in every awk
            seed = seed * 16807 % 2147483647
            return int(seed / 2147483647 * n)
        }
        function allowed(o,   k, word, v) {
            if (k = split(words[o], word, " ")) return word[1 + random(k)]
            # many elements and many steps take their time
            if (whole[o]) return min[o] + random(max[o] < min[o] + 9 ? 2 : 9)
            v = random(2) ? exp(20 - (random(86) / 10) ^ 3) : \
                min[o] + (max[o] - min[o]) * random(999) / 999
            if (random(9) == 0) v = 0
            return sprintf("%.9g", v < min[o] ? min[o] : v > max[o] ? max[o] : v)
        }
        sub(/^  --/, "--") {
            o = $1
            sub(/^.*\]; /, "")
            if (!/^(one of|a number|a whole number)/) next # a file, say
            name[n++] = o
            if (sub(/^one of: /, "")) words[o] = $0
            whole[o] = sub(/^a whole number/, "a number")
            min[o] = $4 + 0; max[o] = $6 + 0
        }
        END {
            split("nan|-inf|1e999||abc|4x|1 2|-1e13|1e13|--n", bad, "|")
            for (; lines > 0; lines--) {
                for (line = ""; random(n + 2); line = line allowed(o) "|")
                    line = line (o = name[random(n)]) (random(2) ? "|" : "=")
                o = name[random(n)]; v = bad[1 + random(10)]
                if ((k = random(4)) > 1) print "allowed||" line
                else if (k) print "refused|" o " " v ": must be |" line o "|" v "|"
                else print "refused|" o "x; -h lists them|" line o "x|"
            }
        }'
}
one_line() { [ "$(wc -l <"$tmp/err")" -eq 1 ] && grep -qF -e "$1" "$tmp/err"; }
for program in $(ls "$BUILD/solutions" | grep '^[0-9][0-9]_[a-z0-9_]*$'); do
    "$BUILD/solutions/$program" -h | random_lines | while IFS= read -r line; do
        text=${line#*|}
        IFS='|'; set -- ${text#*|}; unset IFS
        (ulimit -t 300; exec "$BUILD/solutions/$program" "$@") \
            >"$tmp/out" 2>"$tmp/err" </dev/null
        status=$?
        case ${line%%|*}.$status in
        allowed.0) [ ! -s "$tmp/err" ] ;;
        allowed.1) one_line 'error: ' ;;
        refused.2) [ ! -s "$tmp/out" ] && one_line "${text%%|*}" ;;
        *) false ;;
        esac && ! grep -qiE '(^|	)[-+]?(nan|inf)(	|$)' "$tmp/out" ||
            echo "FAIL cli: $program, $line: status $status, $(head -n 3 "$tmp/err")"
    done >"$tmp/found"
    [ -s "$tmp/found" ] || echo "ok cli: $program, $lines random lines, seed $seed"
    cat "$tmp/found"
done
