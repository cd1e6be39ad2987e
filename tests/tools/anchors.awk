# anchors.awk - links to a place in a page that is not there.
#
#     awk -f tests/tools/anchors.awk FILE... FILE...       every file twice
#
# prints "FILE: LINK".  A place is a heading, by its words in small letters with
# hyphens between them, or an <a id="...">.  First every file is read for its
# places, then again for its links.

function folder(file) { return file ~ /\// ? substr(file, 1, match(file, /[^\/]*$/) - 1) : "" }
# From the top of the tree, without "name/.."
function path(from, to) {
    to = folder(from) to
    while (sub(/[^\/.][^\/]*\/\.\.\//, "", to)) continue
    return to
}
FNR == 1 { fence = 0; seen[FILENAME]++ }
/^ *```/ { fence = !fence }
fence { next }
seen[FILENAME] == 1 {
    line = $0
    while (match(line, /<a id="[^"]*"/)) {
        place[FILENAME "#" substr(line, RSTART + 7, RLENGTH - 8)] = 1
        line = substr(line, RSTART + RLENGTH)
    }
    if ($0 ~ /^#+ /) {
        line = tolower($0)
        sub(/^#+ +/, "", line)
        gsub(/[^a-z0-9 _-]/, "", line)
        gsub(/ /, "-", line)
        place[FILENAME "#" line] = 1
    }
    next
}
{
    line = $0
    gsub(/`[^`]*`/, "", line)
    while (match(line, /\]\([^)#]*#[^)]*\)|^\[[^]]*\]: [^#]*#[^ ]*/)) {
        link = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        sub(/^\]\(|^\[[^]]*\]: /, "", link)
        sub(/\)$/, "", link)
        if (link ~ /^https?:/) continue
        aim = link ~ /^#/ ? FILENAME link : path(FILENAME, link)
        if (!(aim in place)) print FILENAME ": " link
    }
}
