# labels.awk - Does every label of an axis that a script sets stand in its picture?
# gnuplot leaves a label out, without a word, where the margin has no room for it.
#
#     awk -f labels.awk FIGURE.gp FIGURE.svg ...
#
# Of a label its letters up to the first of ^ _ { \ % are looked for, because the rest is
# split where the type changes. A label that is set twice has to stand there twice.
FNR == 1 { report(); script = FILENAME ~ /\.gp$/ }
script && match($0, /(^|[ ;{])set (x|y|x2|y2|cb)label [^"]*"[^"]*/) {
    text = substr($0, RSTART, RLENGTH)
    sub(/^[^"]*"/, "", text)
    sub(/[\^_{\\%].*/, "", text)
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    sub(/ +$/, "", text)
    if (text != "") wanted[text]++
    name = FILENAME
    next
}
!script { for (text in wanted) if (index($0, ">" text)) drawn[text]++ }
END { report() }

function report(    text) {
    if (script) return
    for (text in wanted)
        if (drawn[text] < wanted[text])
            printf "%s: the label \"%s\" is set %d times and drawn %d times\n", name, text, wanted[text], drawn[text]
    delete wanted
    delete drawn
}
