# fold.awk - chapters that tell what they ask to predict.
#
#     awk -f tests/tools/fold.awk lessons/NN_slug.md...
#
# prints "FILE: what is wrong".  The section Predict begins with the line below,
# and all of Measured and of Speed against accuracy stands in one fold each,
# between a first and a last line, so that a reader who stops at Predict has not
# read an answer.

BEGIN {
    stop = "Read as far as this list, write your numbers into the `PREDICT` lines" \
           " of your file, and stop:"
    open = "<details><summary>Measured: open it when your predictions are" \
           " written</summary>"
}
function bad(text) { print file ": " text }
function leave() {
    if (section == "Predict" && first != stop) bad("Predict begins: " first)
    if (section ~ /^(Measured|Speed against accuracy)$/ &&
        (first != open || last != "</details>" || folds != 1))
        bad(section " is not in one fold")
    had = had "," section ","
    section = first = last = ""
    folds = 0
}
function finish() {
    leave()
    if (had !~ /,Predict,.*,Measured,.*,Speed against accuracy,/)
        bad("no Predict, Measured, Speed against accuracy")
    had = ""
}
FNR == 1 {
    if (NR > 1) finish()
    file = FILENAME
}
/^## / {
    leave()
    section = substr($0, 4)
    next
}
/<details/ { folds++ }
$0 != "" {
    if (first == "") first = $0
    last = $0
}
END { if (NR) finish() }
