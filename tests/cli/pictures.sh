#!/bin/sh
# pictures.sh - what `make plot-NN` draws with the course's scripts: a whole
# picture from the tables of the solution, one plain line where a table is not
# there, and a picture or a line, soon, where numbers are wild; and that Figure 6
# of the notes has all its curves.  Prints "ok ..." or "FAIL ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
case $BUILD in /*) built=$BUILD ;; *) built=$PWD/$BUILD ;; esac
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then echo "ok pictures: $2"; else echo "FAIL pictures: $2: $3"; fi
}
into=$BUILD/test/pictures
rm -rf "$into"
mkdir -p "$into/mine"
ln -s "$built/data" "$into/data"
ln -s "$built/solutions" "$into/solutions"
pictures() { BUILD=$into sh tests/tools/student.sh pictures "$1" 2>&1; }
whole() { # of each picture that was said to be there
    echo "$said" | sed -n 's/.* with your numbers: //p' | while read -r file; do
        case $file in
        *.gif) [ "$(tail -c 1 "$file")" = ';' ] ;;
        *) grep -q '</svg>' "$file" ;;
        esac || echo "$file is not whole"
    done
}
# the tables of the solution, NUMBERS put in place of every number but the first
# in a row; with KEPT only rows whose number is no multiple of 3 change
mine() { # mine NUMBERS [KEPT]
    awk -v number="$1" -v kept="${2:-}" 'BEGIN { FS = OFS = "\t" }
        /^#/ { header = 1 }
        NF > 1 && header { header = 0; print; next }
        number != "" && (kept == "" || NR % 3 == 0) {
            for (f = 2; f <= NF; f++) if ($f ~ /^[-+.0-9]+(e|$)/) $f = number }
        { print }' "$built/data/$slug.tsv" >"$into/mine/$slug.tsv"
    cp "$built/solutions/$slug" "$into/mine/$slug"
}

grey='^What is grey behind yours is the reference.$'
lessons=0
for data in "$built"/data/[0-9][0-9]_*.tsv; do
    slug=$(basename "$data" .tsv)
    mine ''
    said=$(pictures "$slug")
    [ -n "$said" ] || continue # no script reads its tables
    lessons=$((lessons + 1))
    bad=$(whole)$(echo "$said" | grep -v -e 'with your numbers: ' -e "$grey")
    result "$([ -z "$bad" ]; echo $?)" "$slug as the solution has it" "$bad"

    # an unfinished program
    : >"$into/mine/$slug.tsv"
    printf '#!/bin/sh\nexit 3\n' >"$into/mine/$slug.sh"
    chmod +x "$into/mine/$slug.sh"
    mv "$into/mine/$slug.sh" "$into/mine/$slug"
    said=$(pictures "$slug")
    bad=$(echo "$said" | grep -v 'not drawn: your program has not printed the table ')
    result "$([ -z "$bad" ] && ! ls "$into/mine/$slug".*.svg >/dev/null 2>&1
        echo $?)" "$slug without a table: one line, and no old picture" "$said"
done
slug=12_triangles
mine ''
said=$(pictures "$slug")
result "$(echo "$said" | grep -q "$grey"; echo $?)" "what is grey is said" "$said"
result "$([ $lessons -ge 18 ]; echo $?)" "at least 18 lessons have one" "$lessons"

for slug in 01_deformation 12_triangles 17_fibres 21_sparse_cholesky 23_least_model; do
    for wild in 'nan kept' inf '1e300 kept' -1e7 '- kept'; do
        mine $wild
        said=$(pictures "$slug")
        bad=$(whole)$(echo "$said" | grep -v -e 'with your numbers: ' -e "$grey" \
            -e 'is not drawn: are all numbers of ')
        result "$([ -n "$said" ] && [ -z "$bad" ]; echo $?)" "$slug with $wild" \
            "$said $bad"
    done
done

# Figure 6 of the notes: energy, stress and r over F, each of the log and of the
# cubic law.  gnuplot writes what it would draw; a curve is there whose points are
# those of the solution's table, at least 50 of them inside the axes.
lost() { # lost COLUMN SCRIPT: the laws without their curve
    rm -f "$into/drawn"
    gnuplot -e "data='$built/data/02_constitutive.tsv'; out='/dev/null'; \
        set table '$into/drawn'" "$2" >/dev/null 2>&1
    awk -v column="$1" '
        function close_to(a, b,    d) { d = a - b
            return (d < 0 ? -d : d) <= 1e-4 * (1 + (b < 0 ? -b : b)) }
        function finish(    law) { # a curve ends
            for (law in rows)
                if (points == rows[law] && inside >= 50 && !off[law]) drawn[law] = 1
            points = inside = 0
            split("", off)
        }
        FILENAME != table { table = FILENAME; file++ }
        file == 1 && /^# curve_/ { law = substr($2, 7); c = 0; next }
        file == 1 && !NF { law = "" }
        file == 1 && (law == "log" || law == "cubic") {
            if (c) { n = ++rows[law]; F[law, n] = $1; y[law, n] = $c; next }
            for (c = NF; $c != column; c--) continue
        }
        file == 2 && (!NF || /^#/) { finish() }
        file == 2 && /^ *[-0-9]/ {
            points++
            inside += $NF == "i"
            for (law in rows)
                if (!close_to($1, F[law, points]) || !close_to($2, y[law, points])) off[law] = 1
        }
        END { finish(); for (law in rows) if (!drawn[law]) print law
              if (!rows["log"] || !rows["cubic"]) print "table" }' \
        "$built/data/02_constitutive.tsv" "$into/drawn" 2>&1 | sort
}
for figure in 'energy psi' 'stress P' 'r r'; do
    name=${figure% *} column=${figure#* }
    script=figures/02_constitutive/$name.gp
    said=$(lost "$column" "$script")
    result "$([ -z "$said" ]; echo $?)" "$name of both laws is drawn" "$said"
    # and it would be seen: a curve less, and another quantity
    for law in log cubic; do
        sed "/data index \"curve_$law\".* with lines/d" "$script" >"$into/script.gp"
        said=$(lost "$column" "$into/script.gp")
        result "$([ "$said" = "$law" ]; echo $?)" "$name without the $law law is noticed" "$said"
    done
    sed "s/\"$column\"/\"dP\"/g" "$script" >"$into/script.gp"
    said=$(echo $(lost "$column" "$into/script.gp"))
    result "$([ "$said" = 'cubic log' ]; echo $?)" "$name of another column is noticed" "$said"
done
for page in README.md lessons/02_constitutive.md; do
    grep -q '^!\[.*/energy\.svg) !\[.*/stress\.svg) !\[.*/r\.svg)$' $page
    result $? "$page shows all three" 'energy.svg stress.svg r.svg'
done
