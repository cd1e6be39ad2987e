#!/bin/sh
# book.sh - what becomes of the book: by cmark-gfm, as on a forge, and by
# `make book`, which has put it into build/test/made, where pandoc is there.  Every
# chapter has its page, every link and picture its aim, every label its row, and
# every formula arrives as it was written.  Prints "ok ...", "FAIL ..." or "skip ...".
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
made=$BUILD/test/made
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
rule() { # rule NAME OFFENDERS
    [ -n "$2" ] || { echo "ok book: $1"; return; }
    printf 'FAIL book: %s: %s\n' "$1" "$2"
}

chapters=$(ls workbook.md lessons/*.md solutions/*.md figures/*/README.md)

# What the lint of links finds, in pages made for it.
tools=$PWD/tests/tools
mkdir "$tmp/lessons"
printf '%s\n' '# A *place*' '[a](../p/place.md#a-place) [b](#b) [c](#c) <a id="c"></a>' \
    >"$tmp/lessons/place.md"
mkdir "$tmp/p" && cp "$tmp/lessons/place.md" "$tmp/p"
rule 'a link to a place that is not there is found' \
    "$(cd "$tmp" && awk -f "$tools/anchors.awk" p/place.md lessons/place.md \
        p/place.md lessons/place.md >said
    [ "$(tr '\n' ' ' <"$tmp/said")" = 'p/place.md: #b lessons/place.md: #b ' ] ||
        cat "$tmp/said")"

# written FILE: its formulas and labels, one per line
written() {
    awk 'function tell() {
            while (match(text, /[`$]+|\[(eq|alg):[A-Za-z0-9-]+\]/)) {
                mark = substr(text, RSTART, RLENGTH)
                text = substr(text, RSTART + RLENGTH)
                if (mark ~ /^\[/) { print mark; continue }
                end = index(text, mark)
                if (mark ~ /[$]/) {
                    formula = substr(text, 1, end - 1)
                    print formula
                    while (match(formula, /\[(eq|alg):[A-Za-z0-9-]+\]/)) {
                        print substr(formula, RSTART, RLENGTH)
                        formula = substr(formula, RSTART + RLENGTH)
                    }
                }
                text = substr(text, end + length(mark))
            }
            text = ""
        }
        /^<!-- labels -->$/ { exit } # the text ends here
        /^ *```/ && math { print text; text = ""; math = 0; next }
        /^ *```/ { tell(); math = /```math/; fence = !math && !fence; next }
        math { text = text $0; next }
        fence { next }
        /^ *$/ { tell() }
        { while ((start = index($0, "<!--")) && (end = index($0, "-->")))
              $0 = substr($0, 1, start - 1) substr($0, end + 3)
          text = text " " $0 }
        END { tell() }' "$1"
}
# Through cmark-gfm, which is what a forge uses.  It leaves $ as it is, and what
# it changes between two of them (an escape, an emphasis, a row of a table that
# is none) the reader of the page gets.  A label must have become a link.
on_a_forge() { # on_a_forge FILE: the same of FILE as text, after cmark-gfm
    # each formula and label is cut out before the text between them
    cmark-gfm --github-pre-lang --unsafe -e table -e strikethrough \
        -e autolink "$1" |
        sed 's/<a href="[^"]*#[ae][lqn][gs]*[-w][^"]*">\([a-z]*:[A-Za-z0-9-]*\)<\/a>/[\1]/g
             s/<a id="[^"]*"><\/a>\[/[/
             s/<pre lang="math"><code>/\
```math\
/; s/<pre[^>]*><code[^>]*>/\
```\
/; s/<\/code><\/pre>/\
```\
/
             s/<\/*code>/`/g; s/<[^>]*>//g' |
        sed "s/&lt;/</g; s/&gt;/>/g; s/&#39;/'/g; s/&quot;/\"/g; s/&amp;/\&/g"
}
if command -v cmark-gfm >/dev/null 2>&1; then
    n=0
    for f in $chapters; do
        written "$f" | tr -d ' ' | grep . | sort >"$tmp/written"
        on_a_forge "$f" >"$tmp/page"
        written "$tmp/page" | tr -d ' ' | grep . | sort >"$tmp/arrived"
        n=$((n + $(wc -l <"$tmp/written")))
        cmp -s "$tmp/written" "$tmp/arrived" && continue
        printf '%s: %s\n' "$f" \
            "$(diff "$tmp/written" "$tmp/arrived" | grep '^[<>]' | head -n 3)"
    done >"$tmp/changed"
    rule "all $n formulas and labels pass cmark-gfm unchanged" "$(cat "$tmp/changed")"
    rule 'every label is a link on a forge, or the row that it leads to' \
        "$(for f in $chapters; do
            cmark-gfm -e table --unsafe "$f" | awk -v f="$f" '
                /<pre/ { pre = 1 }
                !pre { gsub(/<code>[^<]*<\/code>|<!--[^>]*-->|<a id="[^"]*"><\/a>\[[^]]*\]/, "")
                    if (match($0, /\[(eq|alg):[^]]*\]/))
                        print f ": " substr($0, RSTART, RLENGTH) }
                /<\/pre>/ { pre = 0 }'
        done)"
else
    echo 'skip book: cmark-gfm is not on this machine'
fi

# Without pandoc: one line, exit 2, and nothing is made.
mkdir "$tmp/bin"
for tool in sh env; do ln -s "$(command -v $tool)" "$tmp/bin/$tool"; done
said=$(PATH=$tmp/bin BUILD=$tmp/none sh tests/tools/book.sh 2>&1)
status=$?
case $status-$said in 2-*install\ pandoc*) said= ;; esac
[ -z "$said" ] && [ ! -e "$tmp/none" ] || said="status $status: $said"
rule 'without pandoc it says what to install' "$said"
if ! command -v pandoc >/dev/null 2>&1; then
    echo 'skip book: pandoc is not on this machine'
    exit 0
fi

rule 'it is made, and says nothing else' \
    "$(grep -v '^  book ' "$made/said")"
[ -d "$made/book" ] || exit 0
page() { [ "$1" = workbook.md ] && echo index.html || echo "${1%.md}.html"; }
rule 'every chapter has its page' \
    "$(for f in $chapters; do [ -s "$made/book/$(page "$f")" ] || echo "$f"; done)"
pages=$(cd "$made/book" && find . -name '*.html')
# "TO PAGE: AIM" of every link whose aim is a file, and "- PAGE: AIM" where the
# page that it leads to has no such place
aims() {
    awk 'function plain(path) {
            sub(/^\.\//, "", path)
            while (sub(/[^\/.][^\/]*\/\.\.\//, "", path)) continue
            return path
        }
        FNR == 1 { page = plain(FILENAME); folder = page
                   if (!sub(/[^\/]*$/, "", folder)) folder = "" }
        { text = $0
          while (match(text, / id="[^"]*"/)) {
              place[page, substr(text, RSTART + 5, RLENGTH - 6)] = 1
              text = substr(text, RSTART + RLENGTH)
          }
          text = $0
          while (match(text, /(src|href)="[^"]*"/)) {
              aim = substr(text, RSTART, RLENGTH - 1)
              text = substr(text, RSTART + RLENGTH)
              sub(/^[a-z]*="/, "", aim)
              if (aim ~ /^https*:/ || seen[page, aim]++) continue
              id = to = aim
              sub(/#.*/, "", to)
              to = to == "" ? page : plain(folder to)
              print to " " page ": " aim
              if (sub(/^[^#]*#/, "", id)) { wanted[++n] = to SUBSEP id
                                            who[n] = page ": " aim }
          } }
        END { for (k = 1; k <= n; k++) if (!(wanted[k] in place)) print "- " who[k] }' "$@"
}
rule 'every link and every picture has its aim in the book' \
    "$(cd "$made/book" && aims $pages | while read -r to what; do
        [ -s "$to" ] || echo "$what"; done)"

# What the reader sees: no code, no TeX beside its MathML, no linked label.
seen() {
    sed 's/<annotation[^<]*<\/annotation>//g; s/<code>[^<]*<\/code>//g' "$1" |
        awk '/<pre/ { pre = 1 } !pre; /<\/pre>/ { pre = 0 }'
}
rule 'no dollar and no backquote is left of a formula or of code' \
    "$(cd "$made/book" && for f in $pages; do
        seen "$f" | grep -n '[$`]' | sed "s|^|$f:|"; done | cut -c 1-200)"
rule 'every tag that opens is closed, and no piece of one is left' \
    "$(cd "$made/book" && awk -v tags='p a div table td li details math' '
        function tell(    k) { for (k = 1; k <= n; k++) {
            if (open[k]) print page ": " tag[k]
            open[k] = 0 } }
        BEGIN { n = split(tags, tag, " ") }
        FNR == 1 { tell(); page = FILENAME }
        /</ { for (k = 1; k <= n; k++)
                  open[k] += gsub("<" tag[k] "[ >]", "&") - gsub("</" tag[k] ">", "&") }
        END { tell() }' $pages
    for f in $pages; do
        seen "$f" | sed 's/<[^<>]*>//g' | grep '[<>]' | sed "s|^|$f: |"
    done)"
rule 'no label is without its link' \
    "$(cd "$made/book" && for f in $pages; do
        seen "$f" | sed 's/<a class="label"[^>]*>[^<]*<\/a>//g' |
            grep -oE '\[(eq|alg):[^]]*\]' | sed "s|^|$f: |"; done)"

# arrived PAGE: the same of a page
arrived() {
    tr '\n' ' ' <"$1" | sed 's/<annotation[^>]*>/\
<annotation>/g; s/<\/annotation>/&\
/g; s/<a class="label"[^>]*>\(\[[^]]*\]\)/\
<annotation>\1\
/g' | sed -n 's/<\/annotation>//; s/^<annotation>//p' |
        sed "s/&lt;/</g; s/&gt;/>/g; s/&#39;/'/g; s/&quot;/\"/g; s/&amp;/\\&/g"
}
n=0
for f in $chapters; do
    written "$f" | tr -d ' ' | grep . | sort >"$tmp/written"
    arrived "$made/book/$(page "$f")" | tr -d ' ' | grep . | sort >"$tmp/arrived"
    n=$((n + $(wc -l <"$tmp/written")))
    cmp -s "$tmp/written" "$tmp/arrived" && continue
    printf '%s: %s\n' "$f" \
        "$(diff "$tmp/written" "$tmp/arrived" | grep '^[<>]' | head -n 3)"
done >"$tmp/changed"
rule "all $n formulas and labels arrive as they were written" "$(cat "$tmp/changed")"
