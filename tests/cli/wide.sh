#!/bin/sh
# wide.sh - no page of `make book` is wider than the screen that it is read on,
# and the cheat sheet prints on two pages of A4.
#
# A browser without a window lays every page out, with all folds open, for a desk
# (1400 px) and for a phone (390 px), and names what is wider than its box: only
# code, tables, formulas and, on a phone, pictures of several panels may be, which
# scroll there.  Pictures on one line stand side by side on a desk and one below the
# other on a phone.  Without pandoc or a browser it prints "skip ...".
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}"
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
# A selector that ends in a name would match other pictures, too: load_map.svg.
loose=$(grep -nE '\[(src|href)\$="[a-zA-Z_]+\.' tests/tools/book.sh)
if [ -z "$loose" ]; then echo 'ok wide: the style names a picture by its whole path'
else echo "FAIL wide: the style names a picture by its whole path: $loose"; fi
browser=
for name in chromium chromium-browser google-chrome; do
    [ -n "$browser" ] || browser=$(command -v $name)
done
for tool in pandoc "${browser:-a browser (chromium)}"; do
    command -v "$tool" >/dev/null 2>&1 && continue
    echo "skip wide: $tool is not on this machine"
    exit 0
done
cp -R "$BUILD/test/made/book" "$tmp" || { echo 'FAIL wide: there is no book'; exit 0; }
printed() { # the pages of the cheat sheet
    "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$tmp/browser" \
        --print-to-pdf="$tmp/pdf" "file://$tmp/book/lessons/CHEATSHEET.html" >/dev/null 2>&1
    grep -ac '/Type /Page$' "$tmp/pdf"
}
said=$(printed)
if [ "$said" = 2 ]; then echo 'ok wide: the cheat sheet prints on two pages'
else echo "FAIL wide: the cheat sheet prints on two pages: $said"; fi
# and it would be seen: larger letters
cp "$tmp/book/book.css" "$tmp/css" &&
    sed '/CHEATSHEET/s/[0-9.]*pt; line/12pt; line/' "$tmp/css" >"$tmp/book/book.css"
said=$(printed)
cp "$tmp/css" "$tmp/book/book.css"
if [ "${said:-0}" -gt 2 ]; then echo 'ok wide: larger letters need more pages'
else echo "FAIL wide: larger letters need more pages: $said"; fi
cat >"$tmp/look.js" <<'END_OF_SCRIPT'
addEventListener("load", function () {
    var said = [];
    document.querySelectorAll("details").forEach(function (d) { d.open = true; });
    document.querySelectorAll("body *").forEach(function (e) {
        if (e.closest("pre, .wide, math, svg, title, script")) return;
        if (getComputedStyle(e).display.indexOf("inline") == 0) return;
        if (e.querySelector("img:not(.fits)") && innerWidth <= 600) return;
        if (e.querySelector('.wide, img[src="figures/map.svg"]')) return;
        var end = e.getBoundingClientRect().left + e.clientWidth + 1;
        if (Array.from(e.querySelectorAll("math, math *")).some(function (m) {
                return m.getBoundingClientRect().right > end; })) return;
        if (e.scrollWidth > e.clientWidth + 1)
            said.push(e.tagName + " " + e.scrollWidth + " in " + e.clientWidth +
                      ": " + e.textContent.trim().replace(/\s+/g, " ").slice(0, 60));
    });
    document.querySelectorAll(".figure + .figure").forEach(function (f) {
        var beside = f.getBoundingClientRect().top ==
                     f.previousElementSibling.getBoundingClientRect().top;
        if (beside != innerWidth > 600)
            said.push(f.href + (beside ? " beside" : " below") + " the one before");
    });
    document.querySelectorAll("td img").forEach(function (i) {
        if (i.width > 120) said.push("a thumbnail of " + i.width + ": " + i.src);
    });
    if (document.documentElement.scrollWidth > innerWidth)
        said.push("the page " + document.documentElement.scrollWidth);
    parent.postMessage(location.pathname + "\n" + said.join("\n"), "*");
});
END_OF_SCRIPT
cat >"$tmp/look.head" <<'END_OF_HEAD'
<!DOCTYPE html><meta charset="utf-8"><body><pre id="said"></pre><script>
var n = 0;
addEventListener("message", function (m) {
    var line = m.data.split("\n"), page = line.shift();
    line.forEach(function (l) {
        if (l) said.textContent += "AT " + page + ": " + l + "\n";
    });
    document.title = "PAGES " + ++n;
});
</script>
END_OF_HEAD
# looked WIDTH PAGES: a line "PAGE: WHAT" for each offender, and "PAGES LOOKED AT",
# of a few pages at a time, since all are open at once
looked() {
    width=$1
    shift
    while [ $# -gt 0 ]; do
        few=
        while [ $# -gt 0 ] && [ "$(echo $few | wc -w)" -lt 21 ]; do
            few="$few $1"
            shift
        done
        look $width $few
    done | awk '/^PAGES / { n += $2; next } { print } END { print "PAGES " n + 0 }'
}
look() {
    width=$1
    shift
    {   cat "$tmp/look.head"
        for page; do
            echo "<iframe src=\"$page\" width=\"$width\" height=\"900\" style=\"border:0\"></iframe>"
        done
    } >"$tmp/book/look.html"
    "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$tmp/browser" \
        --virtual-time-budget=60000 --window-size="$((width + 100)),1000" \
        --dump-dom "file://$tmp/book/look.html" 2>/dev/null |
        grep -oE '^AT .*|>AT .*|PAGES [0-9]+' | sed "s|^>||; s|^AT $tmp/book/||"
}
pages=$(cd "$tmp/book" && find . -name '*.html' | sed 's|^\./||')
for page in $pages; do
    up=$(dirname "$page" | sed 's|[^/.][^/]*|..|g')
    sed "s|</head>|<script src=\"$up/../look.js\"></script></head>|" \
        "$tmp/book/$page" >"$tmp/page" && mv "$tmp/page" "$tmp/book/$page"
done
count=$(echo "$pages" | wc -l | tr -d ' ')
for width in 1400 390; do
    said=$(looked $width $pages)
    bad=$(printf '%s\n' "$said" | grep -v '^PAGES ')
    printf '%s\n' "$said" | grep -qx "PAGES $count" || bad="of $count pages: $said"
    if [ -z "$bad" ]; then echo "ok wide: $count pages fit a screen of $width px"
    else printf 'FAIL wide: %s\n' "$count pages fit a screen of $width px: $bad"; fi
done
# and it would be seen: a rule for figures/map.svg that matches load_map.svg, too,
# panels that are too wide, and a word that does not break
sed 's|img\[src="figures/map.svg"\]|img[src$="map.svg"]|; s/width: 32.4%/width: 36%/' \
    "$tmp/book/book.css" >"$tmp/css" &&
    mv "$tmp/css" "$tmp/book/book.css"
word=$(printf '%0100d' 1)
sed "s|</h1>|</h1><p>$word</p>|" "$tmp/book/lessons/08_element_assembly.html" >"$tmp/page" &&
    mv "$tmp/page" "$tmp/book/lessons/08_element_assembly.html"
wanted='index.html lessons/02_constitutive.html lessons/08_element_assembly.html'
wanted="$wanted lessons/11_newton_failure.html"
said=$(looked 1400 $wanted | sed 's/:.*//' | sort -u | tr '\n' ' ')
wanted="PAGES 4 $wanted "
if [ "$said" = "$wanted" ]; then
    echo 'ok wide: what is too wide is found'
else echo "FAIL wide: what is too wide is found: $said"; fi
