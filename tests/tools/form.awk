# form.awk - the form that every chapter has.
#
#     awk -f tests/tools/form.awk lessons/NN_slug.md...
#
# prints "FILE: what is wrong", -v rule=NAME only what belongs to that rule:
#   goals     between the head and Scene one paragraph, "When you have finished,
#             you can ...", of at most 45 words
#   sections  their names and their order, as in `order` below
#   marks     exercises On paper are numbered 1., 2., ..., and each begins with
#             *Warm-up.*, *Core.* or *Hard.*
#   break     Break it, what is folded aside, names no source of common/, figures/
#             or solutions/: what is changed there would be judged with
#   own       "You now have" is a list of three, of at most two lines each
#   labels    On paper, [eq:name] is open where Theory has it, or an earlier
#             chapter (give the chapters in their order); elsewhere it is what
#             is asked for, and leads to the answer: [eq:name](../...#answer-6)

BEGIN {
    order = "Scene, Theory, Example, On paper, In code, Predict, Measured, " \
        "Speed against accuracy, Break it, In one sentence, You now have"
}
function bad(which, text) {
    if (rule == "" || rule == which) print file ": " text
}
function finish() {
    if (file == "") return
    leave()
    if (sections != order) bad("sections", "its sections: " sections)
    if (!goals) bad("goals", "no \"When you have finished, you can\" before Scene")
    if (goals > 45) bad("goals", "its goals have " goals " words")
    if (section == "") bad("own", "no sections")
    for (name in here) earlier[name] = 1
    split("", here)
    split("", given)
}
function leave() {
    if (section == "On paper" && !exercises) bad("marks", "no exercise On paper")
    if (section == "You now have" && bullets != 3)
        bad("own", "You now have: " bullets + 0 " bullets, not three")
}
FNR == 1 {
    finish()
    file = FILENAME
    section = sections = ""
    goals = exercises = bullets = fence = folded = in_goals = 0
}
/^ *```/ { fence = !fence }
fence { next }
/^<!-- labels -->$/ { section = "links" }
/^## / {
    leave()
    section = substr($0, 4)
    sections = sections (sections == "" ? "" : ", ") section
    in_goals = 0
    next
}
section == "" && /^When you have finished, you can / { in_goals = 1 }
/^ *$/ { in_goals = 0 }
in_goals {
    line = $0
    gsub(/\$[^$]*\$/, "x", line)
    n = split(line, word, " ")
    for (i = 1; i <= n; i++) goals += word[i] ~ /[A-Za-z0-9]/
}
section == "On paper" && /^[0-9]+\. / {
    exercises++
    if ($1 != exercises ".") bad("marks", "exercise " $1 " is number " exercises)
    if (!/^[0-9]+\. \*(Warm-up|Core|Hard)\.\* /)
        bad("marks", "exercise " $1 " has no mark")
}
/^ *<details/ { folded = 1 }
/<\/details>/ { folded = 0 }
section == "Break it" && !folded && /(common|figures|solutions)\/[a-z0-9_\/]*\.[ch]/ {
    bad("break", "Break it, line " FNR ": a source of the course is changed")
}
section == "You now have" {
    if (/^- /) { bullets++; lines = 0 }
    if (/^(- |  [^ ])/ && ++lines > 2)
        bad("own", "You now have: bullet " bullets " has more than two lines")
}
{
    line = $0
    gsub(/`[^`]*`/, "", line)
    while (match(line, /\[(eq|alg):[A-Za-z0-9-]+\]/)) {
        name = substr(line, RSTART + 1, RLENGTH - 2)
        line = substr(line, RSTART + RLENGTH)
        if (section != "links") here[name] = 1
        if (section ~ /^(Scene|Theory|Example)$/) given[name] = 1
        if (section == "On paper" && line !~ /^\(/ && !(name in given) && !(name in earlier))
            bad("labels", "On paper leads to the row of " name)
    }
}
END { finish() }
