#!/bin/sh
# book.sh - the book as HTML, made by pandoc: BUILD/book/index.html and a page
# for every chapter and for every file of hints and answers, with the slots' code.
#
# Pages lie as the files of the tree do, so that links need a new ending only;
# what they show or name besides is copied.  It works offline, from a file.
set -u
LC_ALL=C
export LC_ALL

if ! command -v pandoc >/dev/null 2>&1; then
    echo 'book: install pandoc first (apt-get install pandoc, or' \
        'brew install pandoc)' >&2
    exit 2
fi
book=${BUILD:-build}/book
new=$book.$$
trap 'rm -rf "$new"' 0
trap 'exit 130' 1 2 15
mkdir -p "$new" || exit 1

cat >"$new/book.css" <<'END'
body { margin: 0; color: #222; font: 18px/1.55 Charter, Georgia, serif; }
main { max-width: 46rem; margin: 0 auto; padding: 1rem 1rem 4rem; }
h1, h2, h3, th, .nav { font-family: "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.6rem; line-height: 1.25; }
h2 { font-size: 1.2rem; margin-top: 2.2rem; }
a, summary { color: #0b5394; }
summary { overflow-wrap: anywhere; }
a.label { font-size: .8em; text-decoration: none; white-space: nowrap; }
.nav { font-size: .85rem; padding: .4em 0; border: solid #ddd; border-width: 1px 0; }
img { max-width: 100%; height: auto; }
@media (min-width: 700px) { p:has(.figure + .figure) img { width: 32.4%; } }
td img { max-width: none; }
math { font-family: math, "STIX Two Math", "Cambria Math", serif; }
mstyle[mathvariant=normal] mi { text-transform: none; }
mstyle[mathvariant=bold] { font-weight: bold; }
code { font: .82em Menlo, Consolas, monospace; overflow-wrap: anywhere; }
pre { overflow-x: auto; line-height: 1.4; padding: .6em .8em; background: #f6f6f3; }
pre code, td code { overflow-wrap: normal; }
.wide { overflow-x: auto; overflow-y: hidden; padding: .2em 0; }
table { border-collapse: collapse; font-size: .85em; line-height: 1.4; }
th, td { padding: .3em .7em .3em 0; vertical-align: top; text-align: left;
         border-bottom: 1px solid #ddd; }
td:has(a:target), p:has(a[id^="alg-"]:target) { background: #fff3c4; }
td a.label { font-size: 1em; }
details { margin: .4em 0; padding-left: .8em; border-left: 3px solid #ddd; }
@media (min-width: 1000px) { img[src="figures/map.svg"] { width: 900px; max-width: none;
    position: relative; left: 50%; transform: translateX(-50%); }
    .wide:has(table) { width: max-content;
    min-width: 100%; max-width: min(64rem, 94vw); position: relative; left: 50%;
    transform: translateX(-50%); }
    details .wide:has(table) { max-width: min(64rem, 50vw + 20rem); left: 0; transform: none; } }
@media (max-width: 600px) { body { font-size: 16px; }
    p, ul, ol { overflow-x: auto; overflow-y: hidden; }
    ul, ol { padding-left: 1.4em; }
    p .figure img[src$=".svg"]:not(.fits) { max-width: none; width: 620px; }
    p:has(.figure + .figure) img { width: 100%; }
    td img { width: 72px; }
    td { min-width: 3.5em; } td a.label { white-space: normal; } }
@media print { @page { size: A4; margin: 12mm; } body { font-size: 10.5pt; }
    main { max-width: none; padding: 0; } .nav { display: none; } h2 { break-after: avoid; }
    tr, img, pre { break-inside: avoid; } a { color: inherit; }
    .CHEATSHEET { font-size: 8.2pt; line-height: 1.3; } .CHEATSHEET h1 { font-size: 14pt; margin: 0; }
    .CHEATSHEET h2 { font-size: 11pt; margin: .6em 0 .1em; } .CHEATSHEET p { margin: .2em 0; }
    .CHEATSHEET #orders-and-constants { break-before: page; margin: 0; }
    .CHEATSHEET table { width: 100%; font-size: 1em; line-height: 1.2; }
    .CHEATSHEET td, .CHEATSHEET th { padding: .1em .5em .1em 0; }
    .CHEATSHEET .wide { margin: 0; padding: 0; overflow: visible; } }
END

# Markers are left out.  Pandoc knows no ```math, and takes what follows a tag for HTML to the next
# empty line.  The links to the neighbours stand at the end, and here also first.
before='
/^(Previous: |\[Contents, ).*workbook\.md\)/ { nav = $0 }
{ line[NR] = $0 }
END {
    if (nav != "") print nav "\n"
    for (i = 1; i <= NR; i++) {
        text = line[i]
        if (text ~ /^ *```/) {
            if (text ~ /```math *$/) { math = "$$"; continue }
            if (math == "") fence = !fence
            else { text = math "$$"; math = "" }
        } else if (math != "") {
            math = math (math == "$$" ? "" : " ") text
            continue
        } else if (!fence) {
            while ((start = index(text, "<!--")) && (end = index(text, "-->")))
                text = substr(text, 1, start - 1) substr(text, end + 3)
            match(text, /^ */)
            indent = sprintf("%" RLENGTH "s", "")
            if (text ~ /<\/summary>./) sub(/<\/summary>/, "&\n\n" indent, text)
            if (text ~ /[^ ].*<\/details>/) sub(/<\/details>/, "\n\n" indent "&", text)
        }
        print text
    }
}'
# Labels are links (tests/tools/workbook.sh); those that stand as code in the index
# of the notes become links to their row of the equations.  Pictures of one panel are
# small enough for a phone; wider ones are scrolled there.
after='
BEGIN {
    n = split(labels, name, " ")
    for (i = 1; i <= n; i++)
        row[name[i]] = row[substr(name[i], index(name[i], ":") + 1)] = name[i]
}
function label(name, text,    id) {
    id = name
    sub(/:/, "-", id)
    return "<a class=\"label\" href=\"" equations "#" id "\">" text "</a>"
}
function changed(part, name, file) {
    if (part ~ /^<img/) {
        match(part, /src="[^"]*"/)
        name = substr(part, RSTART + 4, RLENGTH - 4)
        file = folder "/" substr(name, 2, length(name) - 2)
        while (sub(/[^\/.][^\/]*\/\.\.\//, "", file)) continue
        sub(/^\.\//, "", file)
        if (index(narrow, " " file " ")) sub(/<img/, "<img class=\"fits\"", part)
        return "<a class=\"figure\" href=" name ">" part "</a>"
    }
    name = part
    gsub(/<[^>]*>|[][]/, "", name)
    if (part ~ /^<a id=.*\]$/) {
        sub(/\[.*/, "", part)
        return part label(name, "[" name "]")
    }
    if (part ~ /^<a href=/) {
        sub(/>.*/, ">", part)
        sub(/<a /, "<a class=\"label\" ", part)
        return part "[" name "]</a>"
    }
    if (part ~ /^<code>/ && indexed && name in row) return label(row[name], part)
    return part
}
/<h[12]/ { indexed = /id="index-of-the-notes"/ }
/<pre/ { pre = 1 }
!pre {
    gsub(/>\314\202<\/mo>/, ">^</mo>") # accents that combine would sit beside
    gsub(/>\314\207<\/mo>/, ">\313\231</mo>")
    gsub(/>\314\210<\/mo>/, ">\302\250</mo>")
    sub(/<table>/, "<div class=\"wide\">&")
    sub(/<\/table>/, "&</div>")
    gsub(/<p><math display="block"/, "<p class=\"wide\"><math display=\"block\"")
    if (/^<p>(Previous: |<a [^>]*>Contents, )/) sub(/<p>/, "<p class=\"nav\">")
    n = split($0, bit, /<math /)
    $0 = bit[1]
    for (i = 2; i <= n; i++) {
        if (bit[i] !~ /\\(left|begin)/)
            gsub(/stretchy="true"/, "stretchy=\"false\"", bit[i])
        $0 = $0 "<math " bit[i]
    }
    done = ""
    while (match($0, token)) {
        part = substr($0, RSTART, RLENGTH)
        done = done substr($0, 1, RSTART - 1)
        $0 = substr($0, RSTART + length(part))
        done = done changed(part)
    }
    $0 = done $0
}
/<\/pre>/ { pre = 0 }
{ print }'
cite='(eq|alg):[A-Za-z0-9-]+'
token="<code>[^<]*</code>|<annotation[^<]*</annotation>|<a [^>]*><img [^>]*>"
token="$token|<img [^>]*>|<a id=\"[^\"]*\"></a>\[$cite\]|<a href=\"[^\"]*\">$cite</a>"
token=$(printf '%s' "$token" | sed 's/\\/\\\\/g')

narrow=$(grep -m 1 -oE 'viewBox="0 0 [0-9]+' figures/*.svg figures/*/*.svg |
    awk -F '[: ]' '$NF <= 640 { print $1 }')
table=$(grep -l '^| label | equation' workbook.md lessons/*.md)
labels=$(sed -n 's/^| <a id="[^"]*"><.a>\[\([a-z]*:[A-Za-z0-9-]*\)\].*/\1/p' "$table")
for file in workbook.md lessons/*.md solutions/*.md figures/*/README.md; do
    page=${file%.md}.html
    [ "$file" != workbook.md ] || page=index.html
    up=$(dirname "$file" | sed 's|[^/.][^/]*|..|g; s|^\.$||; s|..$|&/|')
    equations=$(echo "$up$table" | sed 's/workbook\.md$/index.md/; s/md$/html/')
    [ "$file" != "$table" ] || equations=
    mkdir -p "$(dirname "$new/$page")"
    { awk "$before" "$file" >"$new/page.md" &&
      case $file in
      solutions/*) awk -f tests/tools/code.awk "${file%.md}.c" >>"$new/page.md" ;;
      esac &&
      pandoc -f gfm-emoji+tex_math_dollars -t html5 --mathml --wrap=none \
          --fail-if-warnings "$new/page.md" >"$new/page.html"
    } || { echo "book: $file cannot be converted" >&2; exit 1; }
    { echo '<!DOCTYPE html>'
      echo '<html lang="en"><head><meta charset="utf-8">'
      echo '<meta name="viewport" content="width=device-width, initial-scale=1">'
      sed -n 's/&/\&amp;/g; s|^# \(.*\)|<title>\1</title>|p; /^# /q' "$file"
      echo "<link rel=\"stylesheet\" href=\"${up}book.css\"></head>"
      echo "<body class=\"$(basename "$file" .md)\"><main>"
      sed 's|\(href="[^":]*\)\.md\(["#]\)|\1.html\2|g
           s|\(href="[./]*\)workbook\.html|\1index.html|g
           s|>[a-z]*/\([0-9][0-9]\)_[a-z0-9_]*\.md</a>|>lesson \1</a>|g' "$new/page.html" |
          awk -v equations="$equations" -v labels="$(echo $labels)" \
              -v folder="$(dirname "$file")" -v narrow=" $(echo $narrow) " \
              -v token="$token" "$after"
      echo '</main></body></html>'
    } >"$new/$page"
    grep -oE '(src|href)="[^":#]+"' "$new/$page" | sed 's/.*="//; s/"$//' |
        grep -vE '\.(html|css)$' | sort -u | while read -r target; do
            from=$(dirname "$file")/$target
            to=$(dirname "$new/$page")/$target
            mkdir -p "$(dirname "$to")" && cp "$from" "$to" || exit 1
        done || exit 1
done
rm -f "$new/page.md" "$new/page.html"
rm -rf "$book"
mv "$new" "$book" || exit 1
echo "  book     $book/index.html: $(find "$book" -name '*.html' | wc -l | tr -d ' ') pages"
