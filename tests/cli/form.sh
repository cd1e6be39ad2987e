#!/bin/sh
# form.sh - the rules of the form of chapters and answers let the skeleton of a
# new lesson pass, and find each mistake that is made in it; those of pictures, too.
#
# Prints "ok form: ..." or "FAIL form: ...".
set -u
LC_ALL=C
export LC_ALL
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
rule() { # rule NAME OFFENDERS
    [ -n "$2" ] || { echo "ok form: $1"; return; }
    printf 'FAIL form: %s: %s\n' "$1" "$2"
}
chapter=$tmp/98_spring.md answers=$tmp/answers.md code=$tmp/98.c checks=$tmp/checks.c
of_lesson() { # of_lesson SKELETON FILE
    sed 's/@NN@/98/g; s/@N@/98/g; s/@NAME@/spring/g; s/@PLACE@/6 1/g
         s|<!-- code .*|&\
```c\
y[0] = 0.0;\
```|' "tests/tools/skeleton/$1" >"$2"
}
of_lesson chapter.md "$chapter"
of_lesson solution.md "$answers"
of_lesson solution.c "$code"
of_lesson checks.c "$checks"
chapter_says() { awk -v rule="$1" -f tests/tools/form.awk "$2"; }
answers_say() {
    awk -v rule="$1" -f tests/tools/answers.awk "$chapter" "$code" "$checks" "$2"
}
rule 'the skeleton of a chapter and of its answers has the form' \
    "$(chapter_says '' "$chapter"; answers_say '' "$answers")"

# found WHICH EDIT: nothing if rule WHICH finds what sed has made of the page
found() {
    sed "$2" "$page" >"$tmp/edited" || echo "$2 is no edit"
    cmp -s "$page" "$tmp/edited" && echo "$2 changes nothing"
    said=$("${page##*/}" "$1" "$tmp/edited")
    [ -n "$said" ] || echo "$1: $2"
    others=$("${page##*/}" '' "$tmp/edited" | grep -vxF -e "$said")
    [ -z "$others" ] || [ "${3:-}" = more ] || echo "$1: $2: $others, too"
}
cp "$chapter" "$tmp/chapter_says"
page=$tmp/chapter_says
words45=$(awk 'BEGIN { for (i = 0; i < 45; i++) printf "word " }')
rule 'a chapter without its goals, or with too many words there, is found' \
    "$(found goals '/^When you have/d'
    found goals "s/^When you have finished, you can/& $words45/"
    found goals 's/^When you have finished/After this/'
    found goals '/^When you have/{h;d;};/^## Theory/{G;}')"
rule 'a section that is missing, moved, added or renamed is found' \
    "$(found sections '/^## Example/d'
    found sections 's/^## Example/## Worked example/'
    found sections '/^## You now have/d'
    found sections 's/^## Break it/## Break/'
    found sections 's/^## Predict/## History\
\
&/'
    found sections 's/^## In code/## Predictx/; s/^## Predict$/## In code/; s/Predictx/Predict/' more)"
rule 'an exercise without a mark, or with a wrong one or number, is found' \
    "$(found marks 's/^1\. \*Warm-up\.\* /1. /'
    found marks 's/^2\. \*Core\.\*/2. *Easy.*/'
    found marks 's/^2\. \*Core/3. *Core/'
    found marks '/^[12]\. \*/d' more)"
rule 'a bullet too many, too few or too long in "You now have" is found' \
    "$(found own '/^- TODO: a tool/d'
    found own 's/^- TODO: a tool.*/&\
- another/'
    found own 's/^- TODO: a tool.*/&\
  that has\
  three lines/')"
rule 'a label On paper that leads to the answer is found' \
    "$(found labels 's/^2\. \*Core\.\*/& [eq:reaction]/'
    sed 's/^2\. \*Core\.\*/& [eq:reaction]/; s/^TODO: what one has/[eq:reaction] &/' \
        "$chapter" >"$tmp/given" && chapter_says labels "$tmp/given"
    sed 's/^2\. \*Core\.\*/& [eq:reaction](..\/solutions\/a.md#answer-2)/' \
        "$chapter" >"$tmp/asked" && chapter_says labels "$tmp/asked"
    sed 's/^2\. \*Core\.\*/& [eq:reaction]/' "$chapter" >"$tmp/late"
    awk -v rule=labels -f tests/tools/form.awk "$tmp/given" "$tmp/late")"
rule 'a source of the course that is changed in Break it is found' \
    "$(found break 's|^- TODO: something to change|- In common/bar/poisson.c|'
    found break 's|^- TODO: something to change|- In [it](../figures/a/b.c)|'
    sed 's|^  TODO: what happens|  As in common/bar/poisson.c|' "$chapter" >"$tmp/folded"
    chapter_says break "$tmp/folded")"

answers_page() { answers_say "$@"; }
cp "$answers" "$tmp/answers_page"
page=$tmp/answers_page
hint_of_check='<details><summary>Hint 1: values_lie_on_the_line</summary>\
\
x\
\
</details>'
rule 'hints out of order are found' \
    "$(found hints 's/Hint 1: slot 98b/Hint 2: slot 98b/'
    found hints 's/Hint 2: slot 98a/Hint 2: slot 98b/; s/Hint 1: slot 98b/Hint 2: slot 98a/'
    found hints "s|^<details><summary>Hint 1: slot 98a.*|$hint_of_check\\
&|"
    found hints "s|^<a id=.answer-1.*|$hint_of_check\\
&|"
    found hints "s|^<a id=.answer-2.*|$hint_of_check\\
&|"
    sed "s|^<details><summary>Hint 1: slot 98b.*|$hint_of_check\\
&|" "$answers" >"$tmp/right" && answers_say '' "$tmp/right")"
rule 'an answer, a fold or a name that is missing or wrong is found' \
    "$(found answers 's/Answer 2: /Answer 3: /'
    found answers 's/Answer 2: [^<]*/Answers 2 to 4/'
    found answers 's/Answer 2: [^<]*/Answer 2/'
    found answers '/^<a id="answer-2"/d'
    found answers 's/^<a id="answer-2"/<a id="answer-02"/'
    found answers 's/^<a id="answer-2".*/&\
/'
    found answers 's/>Predictions</>The predictions</'
    found answers '/^2\. TODO: the same/d'
    found answers '/^<a id="predictions"/,/^<.details>/d'
    found answers '/^<a id="code-98b"/,/^<.details>/d'
    found answers 's/Code of slot 98b/Code of slot 98a/'
    found answers '/^```c/,/^```$/d'
    found answers 's/^<a id="predictions".*/The code:\
\
&/')"

# ---- words and sentences -----------------------------------------------------
made() { # made SECTION WORDS: a page with so many words in this section
    awk -v name="$1" -v n="$2" 'BEGIN {
        print "## " name
        for (i = split(name, word, " "); i < n; i++) print "word" }'
}
long() { # long PART MOST: which of the sections in $tmp/page are too long
    awk -v part="$1" -v most="$2" -f tests/tools/words.awk "$tmp/page"
}
rule 'a section is counted with its part, and by no other' \
    "$({ made Theory 300; made Example 300; made 'On paper' 1100; } >"$tmp/page"
    long Theory,Example 600; long Example 300; long rest 1100
    [ "$(long '' 1699)" = "1700 $tmp/page" ] || echo whole
    for more in Theory Example 'On paper'; do
        { made Theory 300; made Example 300; made 'On paper' 1100; made "$more" 2
        } >"$tmp/page"
        [ "$(long Theory,Example 600)$(long Example 300)$(long rest 1100)" ] || echo "$more"
    done)"
cat >"$tmp/page" <<'END_OF_PAGE'
# Lesson 98: Ten sentences

*Lecture 2. About 90 minutes. Rests on nothing.*

## Scene

*Figure 98.1. A short one, the first. It is not a short one, since it has more than eight words.*

**Run-in.** *Italics.* It has a formula $a + b = c$ and, by Newton (3.1.4), e.g. some other words,
which is long. Why $x$? The energy is

```math
E = m c^2
```

[eq:energy] and the sentence goes on behind the display, to its end. The table has it:

| a. B. c. | d. |
|---|---|

<details><summary>Measured: open it when your predictions are written</summary>

"Is it?" 3.14 is a number, and the fourth short sentence starts here: no. No stop

- At one place J. Newton and nobody else had it right in all of the lines. Short.
  <details><summary>Outcome</summary>

  Not shown. Not counted.

  </details>

</details>
END_OF_PAGE
rule 'short sentences are counted' \
    "$(said=$(awk -v short=8 -f tests/tools/words.awk "$tmp/page")
    [ "$said" = "44.4 % $tmp/page: 4 of 9" ] ||
        awk -v short=8 -v list=1 -f tests/tools/words.awk "$tmp/page"
    awk -v short=8 -v most=45 -f tests/tools/words.awk "$tmp/page"
    [ "$(awk -v short=8 -v most=44 -f tests/tools/words.awk "$tmp/page")" ] || echo 44)"

# ---- minutes -----------------------------------------------------------------
cat >"$tmp/timed.md" <<'END_OF_PAGE'
# Lesson 98: Minutes

*About 5 minutes. Rests
on nothing.*

## On paper

1. *Warm-up.* One.
2. *Core.* Two, which takes About 3 minutes.
3. *Hard.* Three.

## Predict

1. How many?
2. How many more? Or less?

## Measured

1. A list of another section.
END_OF_PAGE
cat >"$tmp/timed.c" <<'END_OF_CODE'
int before;
    /* SLOT 98a(x): a contract
       of two lines. */
    /* a comment
     * over lines */ x = 1;

    for (;;) {
        x++; /* a reason */
    }
    /* END 98a */
int behind;
END_OF_CODE
# 600 words, 5 + 10 + 20, 2 questions, 3 lines: 10 + 35 + 6 + 3 = 54
timed() { awk -v words="$1" -f tests/tools/minutes.awk "$tmp/timed.md" ${2:+"$2"}; }
rule 'minutes follow their rule' \
    "$(said=$(awk -v parts=1 -v words=600 -f tests/tools/minutes.awk "$tmp/timed.md" \
        "$tmp/timed.c" | tr '\n' ' ')
    [ "$said" = '10 35 6 3 55 ' ] || echo "$said"
    [ "$(timed 630)" = 50 ] && [ "$(timed 720)" = 55 ] || echo 'without slots'
    sed '/^## Predict/,$s/^[12]\. //' "$tmp/timed.md" >"$tmp/asked.md"
    said=$(awk -v words=0 -v parts=1 -f tests/tools/minutes.awk "$tmp/asked.md" | head -n 1)
    [ "$said" = '0 35 9 0' ] || echo "questions without numbers: $said")"
filled() { # filled MINUTES FILE
    awk -v minutes="$1" -v only=lead -v data="$tmp" -f tests/tools/workbook.awk "$2"
}
rule 'minutes and hours are filled, and nothing else' \
    "$(filled 75 "$tmp/timed.md" | diff "$tmp/timed.md" - | grep '^[<>]' >"$tmp/said"
    [ "$(tr '\n' ' ' <"$tmp/said")" = '< *About 5 minutes. Rests > *About 75 minutes. Rests ' ] ||
        cat "$tmp/said"
    echo 'a <!-- hours 1-2 7 -->0<!-- /hours --> b' >"$tmp/sum"
    said=$(filled '01 100 02 40 03 1000 07 25 ' "$tmp/sum")
    [ "$said" = 'a <!-- hours 1-2 7 -->3<!-- /hours --> b' ] || echo "$said"
    said=$(filled '01 100 02 40 03 1000 07 55 ' "$tmp/sum")
    [ "$said" = 'a <!-- hours 1-2 7 -->3 1/2<!-- /hours --> b' ] || echo "$said")"

cat >"$tmp/axes.gp" <<'X'
set xlabel "a & b < c"
if (left) { set ylabel (left ? "error of u_h (m)" : "") }
set ylabel y_name
set ylabel "error of u_h (m)"
X
labels_of() { # labels_of SVG: the labels that are not there
    printf "$1" >"$tmp/axes.svg"
    awk -f tests/tools/labels.awk "$tmp/axes.gp" "$tmp/axes.svg" | sed 's/.*"\(.*\)".*set/\1: set/'
}
texts='<text>a &amp; b &lt; c</text><text>error of u\n<text>error of u'
rule 'a label of an axis that is not in the picture is found' \
    "$(labels_of "$texts"
    [ "$(labels_of "${texts%\\n*}")" = 'error of u: set 2 times and drawn 1 times' ] || echo 'one of two'
    [ "$(labels_of "${texts#*</text>}")" = 'a &amp; b &lt; c: set 1 times and drawn 0 times' ] || echo 'none')"
