# answers.awk - what is wrong with the form of a file of hints and answers.
#
#     awk -f tests/tools/answers.awk lessons/NN_slug.md solutions/NN_slug.md
#
# Behind the hints there is a fold for each exercise On paper, in their order, and one
# for the predictions; before each the line that gives it a name:
#
#     <a id="answer-1"></a>
#     <details><summary>Answer 1: the exact solution</summary>
#
# (predictions: "Predictions").  No text stands outside a fold, and each question of
# Predict has its number in the fold of the predictions.

function bad(text) { print text }
FNR == 1 { part++; section = "" }
part == 1 && /^## / { section = substr($0, 4) }
part == 1 && section == "On paper" && /^[0-9]+\. / { exercises++ }
part == 1 && section == "Predict" && /^[0-9]+\. / { questions++ }
part < 2 { next }
FNR == 1 || /^The chapter: / { next }
/^<!-- labels -->$/ { exit }
/^ *```/ { fence = !fence }
fence { next }
/^<a id="/ { id = $0; gsub(/^<a id="|"><\/a>$/, "", id); before = FNR; next }
/^<details>/ {
    inside++
    title = $0
    gsub(/<[^>]*>/, "", title)
    is = ""
    if (title ~ /^Hint /) next
    if (match(title, /^Answer [0-9]+: ./)) {
        last++
        is = "answer-" substr(title, 8) + 0
        if (is != "answer-" last) bad("\"" title "\" is answer " last)
    } else if (title == "Predictions") is = "predictions"
    else if (title ~ /^(Answer|Prediction)/) bad("\"" title "\" has another name")
    if (is != "") {
        seen[is]++
        if (before != FNR - 1 || id != is)
            bad("before \"" title "\" there is no <a id=\"" is "\"></a>")
    }
    next
}
/^<\/details>/ { inside--; next }
!inside && NF && !/^<!--.*-->$/ {
    if (!outside++) bad("outside of a fold: " substr($0, 1, 60))
}
inside && is == "predictions" && /^[0-9]+\. / { answer[$1 + 0] = 1 }
END {
    for (i = 1; i <= exercises; i++)
        if (!seen["answer-" i]) bad("no \"Answer " i ": ...\" for exercise " i)
    if (last > exercises) bad(last " answers to " exercises + 0 " exercises")
    if (!seen["predictions"]) bad("no fold \"Predictions\"")
    else for (i = 1; i <= questions; i++)
        if (!(i in answer)) bad("Predictions have no answer " i ".")
    for (i in seen) if (seen[i] > 1) bad(i " is there " seen[i] " times")
}
