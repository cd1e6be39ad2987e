#!/bin/sh
# web_choose.sh BUILD - what choose.html knows, as a script: the table of the words, which
# form.c prints, what scene_file.h says of each, the program's options, of choose -h, the
# example scenes, and the pages of the lessons.
set -u
LC_ALL=C
export LC_ALL
text() { # text [FILE]: as a template of JavaScript
    printf '`'
    sed 's/\\/\\\\/g; s/`/\\`/g; s/\$/\\$/g' "$@"
    printf '`'
}
words=$("$1/lessons/web/form") && help=$("$1/choose" -h) || exit
printf 'self.choose = {\nwords: '
echo "$words" | text
printf ',\nhelp: '
echo "$help" | text
printf ',\nsays: {\n'
# " *     width    0.08               m; it lies along X1"
awk '/^ \*     [A-Za-z]+ +[^ ]/ && !done {
        line = $0
        sub(/^ \*     /, "", line)
        word = line; sub(/ .*/, "", word)
        # behind the value: two blanks or more
        rest = line; sub(/^[A-Za-z]+ +/, "", rest)
        value = rest; sub(/  +.*/, "", value)
        what = ""
        if (match(rest, /  +/)) what = substr(rest, RSTART + RLENGTH)
        gsub(/["\\]/, "", what)
        printf "\"%s\": [\"%s\", \"%s\"],\n", word, value, what
    }
    /^ \* A line is a word/ { done = 1 }' common/choice/scene_file.h
printf '},\nscenes: {\n'
for scene in lessons/scenes/*.scene; do
    name=${scene##*/}
    printf '"%s": ' "${name%.scene}"
    text "$scene"
    echo ,
done
printf '},\nlessons: {\n'
for lesson in lessons/[0-9][0-9]_*.md; do
    name=${lesson##*/}
    name=${name%.md}
    number=${name%%_*}
    echo "\"${number#0}\": \"../lessons/$name.html\","
done
echo '} };'
