# whole.awk - is a lesson whole, and do its parts name each other as they are?
#
#     awk -v nn=NN -f tests/tools/whole.awk solutions/NN_slug.c lessons/NN_slug.md \
#         tests/checks/NN_slug.c tests/mistakes/NN_slug.txt solutions/NN_slug.md .clangd
#
# prints lines "RULE what is wrong":
#   whole        the title of the chapter, a line Plot:, ARGS in the line Run, five
#                mistakes, one of them NONFINITE, an equivalent, three hints for each
#                slot, a line in .clangd
#   predictions  two or more, the same in the header of the solution, where each is
#                three dots, in the checks, and in the section Predict
#   hints, mistakes    name checks, or slots, that there are

function bad(rule, text) { print rule " " text }
# Does line quote NAME, in quotation marks?  All names are kept that do.
function quoted(line,    name) {
    while (match(line, /"[a-z_0-9A-Z]+"/)) {
        name = substr(line, RSTART + 1, RLENGTH - 2)
        line = substr(line, RSTART + RLENGTH)
        check[name] = 1
        if (measuring && name ~ /^[0-9][a-z]?$/) measured[name] = 1
    }
}
FNR == 1 { part++; predict = 0 }
part == 1 {
    if (/^ \* Plot: /) plot = 1
    if (/^ \* Run .*ARGS=-h/) args = 1
    if (/PREDICT/) lines++
    if (match($0, /^ \* PREDICT [0-9a-z]+ [^:]*: \.\.\.$/)) asked[$3] = ++n_asked
    if (match($0, /\/\* SLOT [0-9]+[a-z]\(/))
        slot[substr($0, RSTART + 8, RLENGTH - 9)] = 1
}
part == 2 && FNR == 1 && index($0, "# Lesson " nn ": ") != 1 { bad("whole", "title of the chapter") }
part == 2 && /^## / { predict = /^## Predict/ }
part == 2 && predict && /^[0-9]+\. / { question[$1 + 0] = 1 }
part == 3 {
    if (/^static void what_was_predicted/) measuring = 1
    quoted($0)
    if (/^}/) measuring = 0
}
part == 4 {
    mistakes += /^mistake: /
    nonfinite += /^verdict: NONFINITE/
    equivalents += /^equivalent: /
    if (/^(caught-by|also-by): /) caught[$2] = 1
}
part == 5 && match($0, /<summary>Hint [123]: [^<]*/) {
    hint[substr($0, RSTART + 14, RLENGTH - 14)] = 1
}
part == 6 && /tests\/checks\// && $0 ~ "tests/checks/" nn "_" { editor = 1 }
END {
    if (!plot) bad("whole", "line Plot:")
    if (!args) bad("whole", "ARGS in the line Run")
    if (mistakes < 5) bad("whole", "five mistakes")
    if (!nonfinite) bad("whole", "a NONFINITE mistake")
    if (!equivalents) bad("whole", "an equivalent program")
    if (!editor) bad("whole", "line of .clangd")
    for (s in slot)
        for (level = 1; level <= 3; level++)
            if (!((level ": slot " s) in hint)) bad("whole", "hint " level " for " s)
    if (lines != n_asked) bad("predictions", "a line is malformed")
    if (n_asked < 2) bad("predictions", "too few")
    for (key in asked) {
        if (!(key in measured)) bad("predictions", key " is not measured")
        if (!((key + 0) in question)) bad("predictions", "no " key " in the chapter")
    }
    for (key in measured) if (!(key in asked)) bad("predictions", key " is not asked")
    for (h in hint) {
        what = substr(h, 4)
        if (what ~ /^slot / ? !(substr(what, 6) in slot) : \
                !(what in check) && what != "same_numbers_as_reference")
            bad("hints", what)
    }
    for (name in caught)
        if (!(name in check) && name !~ /^same_(numbers_as_reference|in_another_order)$/)
            bad("mistakes", name)
}
