# answers.awk - the form that every file of hints and answers has.
#
#     awk -f tests/tools/answers.awk lessons/NN_slug.md solutions/NN_slug.c \
#         tests/checks/NN_slug.c solutions/NN_slug.md
#
# prints what is wrong; -v rule=NAME only what belongs to that rule:
#   hints    by slot, then by level: the three of a slot, then those of the checks
#            that are about this slot, then the next slot
#   answers  behind the hints a fold for each exercise On paper, in their order,
#            one for the predictions, and one for each slot, with code; before
#            each the line that gives it a name:
#
#                <a id="answer-1"></a>
#                <details><summary>Answer 1: the exact solution</summary>
#
#            (predictions: "Predictions"; code-7a: "Code of slot 7a"); no text
#            stands outside a fold, and each question of Predict has its number
#            in the fold of the predictions

function bad(which, text) {
    if (rule == "" || rule == which) print text
}
FNR == 1 { part++; section = "" }
part <= 1 && /^## / { section = substr($0, 4) }
part == 1 && section == "On paper" && /^[0-9]+\. / { exercises++ }
part == 1 && section == "Predict" && /^[0-9]+\. / { questions++ }
part == 2 && match($0, /\/\* SLOT [0-9]+[a-z]\(/) {
    slot[++slots] = substr($0, RSTART + 8, RLENGTH - 9)
    number[slot[slots]] = slots
}
# the claims: {"name", function, "7a"}, over one line or two
part == 3 && /^static const struct claim/ { claims = 1 }
part == 3 && claims {
    line = line $0
    if (/^};/) claims = 0
    while (match(line, /\{"[a-z_0-9A-Z]+",[^}]*\}/)) {
        one = substr(line, RSTART + 2, RLENGTH - 2)
        line = substr(line, RSTART + RLENGTH)
        name = one
        sub(/".*/, "", name)
        sub(/^[^,]*,[^,]*/, "", one)
        if (match(one, /"[0-9]+[a-z]/)) about[name] = substr(one, RSTART + 1, RLENGTH - 1)
    }
}
part < 4 { next }
FNR == 1 || /^The chapter: / { next }
/^<!-- labels -->$/ { exit }
/^ *```/ { if (!fence && /```c/) code = 1; fence = !fence }
fence { next }
/^<details><summary>Hint / {
    text = $0
    gsub(/<[^>]*>/, "", text)
    level = substr(text, 6, 1) + 0
    of = substr(text, 9)
    if (answered) bad("hints", text " stands behind the answers")
    if (of ~ /^slot /) {
        k = number[substr(of, 6)]
        if (!(k == at && level == reached + 1 || k == at + 1 && level == 1 && (!at || reached == 3)))
            bad("hints", text " stands behind Hint " reached + 0 " of slot " slot[at])
        at = k
        reached = level
        named = 0
    } else if (of in about && (about[of] != slot[at] || reached != 3))
        bad("hints", text " is about slot " about[of] ", and stands behind Hint " reached + 0 " of slot " slot[at])
}
/^<a id="/ { id = $0; gsub(/^<a id="|"><\/a>$/, "", id); before = FNR; next }
/^<details>/ {
    inside++
    title = $0
    gsub(/<[^>]*>/, "", title)
    is = ""
    if (title ~ /^Hint /) { next }
    answered = 1
    if (match(title, /^Answer [0-9]+: ./)) {
        last++
        is = "answer-" substr(title, 8) + 0
        if (is != "answer-" last) bad("answers", "\"" title "\" is answer " last)
    } else if (title == "Predictions") is = "predictions"
    else if (title ~ /^Code of slot /) is = "code-" substr(title, 14)
    else if (title ~ /^(Answer|Code|Prediction)/) bad("answers", "\"" title "\" has another name")
    if (is != "") {
        seen[is]++
        if (before != FNR - 1 || id != is)
            bad("answers", "before \"" title "\" there is no <a id=\"" is "\"></a>")
    }
    code = 0
    next
}
/^<\/details>/ {
    inside--
    if (is ~ /^code-/ && !code) bad("answers", is " has no code")
    next
}
!inside && NF && !/^<!--.*-->$/ {
    if (!outside++) bad("answers", "outside of a fold: " substr($0, 1, 60))
}
inside && is == "predictions" && /^[0-9]+\. / { answer[$1 + 0] = 1 }
END {
    for (i = 1; i <= exercises; i++)
        if (!seen["answer-" i]) bad("answers", "no \"Answer " i ": ...\" for exercise " i)
    if (last > exercises) bad("answers", last " answers to " exercises + 0 " exercises")
    if (!seen["predictions"]) bad("answers", "no fold \"Predictions\"")
    else for (i = 1; i <= questions; i++)
        if (!(i in answer)) bad("answers", "Predictions have no answer " i ".")
    for (i = 1; i <= slots; i++)
        if (!seen["code-" slot[i]]) bad("answers", "no \"Code of slot " slot[i] "\"")
    for (i in seen) if (seen[i] > 1) bad("answers", i " is there " seen[i] " times")
}
