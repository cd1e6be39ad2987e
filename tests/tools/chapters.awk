# chapters.awk - pictures that are not numbered in their order, and links that
# do not lead to the chapter before and behind.
#
#     awk -f tests/tools/chapters.awk CHAPTER...      in the order of the book
#
# prints "FILE: what is wrong".  The pictures of a chapter are Figure X.1, X.2, ...,
# at most four in a lesson, each with its caption behind it; X is the number of a
# lesson, and a letter elsewhere.  The text names each before it comes, but for the
# first, which opens the chapter, and no other number of this kind.  Those on one
# line are one picture: side by side on a wide page, one below the other on a phone.

function base(path) { sub(/.*\//, "", path); return path }
# The name by which a link knows a chapter: its file, or folder/README.md.
function name(path) {
    return path ~ /README/ ? base(substr(path, 1, length(path) - 10)) "/README.md" \
                           : base(path)
}
function bad(text) { print file ": " text }
function finish(    i) {
    if (file == "") return
    if (pictures != captions) bad(pictures " pictures, " captions " captions")
    if (file ~ /^lessons/ && pictures > 4) bad(pictures " pictures")
    for (i in cited) if (cited[i] > captions) bad("no Figure " letter "." cited[i])
    split("", cited)
    split("", named)
    if (before_is != "" && before !~ name(before_is) "\\)") bad("previous")
    if (behind_is != "" && behind !~ name(behind_is) "\\)") bad("next")
    if (behind_is == "" && behind != "") bad("next")
}
BEGIN { for (i = 1; i < ARGC; i++) path[i] = ARGV[i] }
FNR == 1 {
    finish()
    file = FILENAME
    k++
    before_is = path[k - 1]
    behind_is = path[k + 1]
    pictures = captions = n_cited = 0
    before = behind = letter = ""
    if (file ~ /^lessons/) letter = substr(base(file), 1, 2)
}
/^ *```/ { fence = !fence }
fence { next }
/^!\[/ { pictures++ }
/^\*Figure / {
    captions++
    text = $2
    sub(/\.$/, "", text)
    if (letter == "") letter = substr(text, 1, 1)
    if (text != letter "." captions) bad("Figure " text " is number " captions)
    if (captions != pictures) bad("Figure " text " has no picture before it")
    if (captions > 1 && !(captions in named)) bad("Figure " text " comes unannounced")
}
{
    line = $0
    while (match(line, /[Ff]igures? ([0-9][0-9]|[A-Z])\.[0-9]/)) {
        text = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        sub(/^[^ ]* /, "", text)
        split(text, part, ".")
        if (letter == "" ? part[1] ~ /[A-Z]/ : part[1] == letter) {
            cited[++n_cited] = part[2]
            named[part[2]] = 1
        }
    }
}
/^Previous: / { before = $0; sub(/\|.*/, "", before) }
/next: / { behind = $0; sub(/.*next: /, "", behind) }
END { finish() }
