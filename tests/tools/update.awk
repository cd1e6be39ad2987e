# update.awk - set what a student wrote into another starter.
#
#     awk [-v report=FILE -v kept=FILE] [-v strict=1] -f tests/tools/update.awk \
#         [f=1 OLD] f=2 MINE f=3 NEW
#
# prints NEW with what MINE has in its slots and behind the colons of its PREDICT
# lines, but for what is still as in OLD.  A slot is what starter.awk says; one
# without its END is none.  In the report stands what was set in, and what was not
# because NEW has no place for it, or, if strict, asks for something else there;
# it is to be found in the file KEPT.

FNR == 1 { sub(/^\357\273\277/, "") } # the mark that some editors set
{ sub(/\r+$/, ""); line[f, ++lines[f]] = $0 }

function joined(first, last,    all) {
    for (; first <= last; first++) all = all line[f, first] "\n"
    return all
}
# A part of file f: in line `first` begins what is asked, and behind that, up to
# line `last`, stands what is answered.
function part(name, first, last, question, answer) {
    if ((f, name) in asked) return
    name_of[f, ++parts[f]] = name
    part_at[f, first] = name
    last_of[f, name] = last
    asked[f, name] = question
    answered[f, name] = answer
}
function find_parts(    i, j, k, name, colon, ending) {
    for (i = 1; i <= lines[f]; i++) {
        name = line[f, i]
        if (name ~ /^ \* PREDICT [0-9]+[a-z]?[ :].*:/) {
            colon = index(name, ":")
            match(name, /PREDICT [0-9]+[a-z]?/)
            part(substr(name, RSTART, RLENGTH), i, i,
                 substr(name, 1, colon - 1), substr(name, colon) "\n")
        } else if (name ~ /\/\* SLOT [0-9]+[a-z]\(/) {
            sub(/.*\/\* SLOT /, "", name)
            sub(/\(.*/, "", name)
            ending = "/\\* END " name " \\*/"
            for (j = i; j < lines[f] && line[f, j] !~ /\*\//; j++) ;
            for (k = j + 1; k < lines[f] && line[f, k] !~ ending &&
                            line[f, k] !~ /\/\* SLOT /; k++) ;
            if (line[f, k] !~ ending) continue
            part("slot " name, i, k - 1, joined(i, j), joined(j + 1, k - 1))
        }
    }
}
function bare(words) { gsub(/[ \t\n]/, "", words); return words }
function wrote(name) { # there is something of the student's
    return (2, name) in asked && \
           bare(answered[1, name]) != bare(answered[2, name])
}
function fits(name) {
    return wrote(name) && (3, name) in asked &&
           !(strict && asked[1, name] != asked[3, name])
}
END {
    for (f = 1; f <= 3; f++) find_parts()
    for (i = 1; i <= lines[3]; i++) {
        name = part_at[3, i]
        if (fits(name)) {
            printf "%s%s", asked[3, name], answered[2, name]
            i = last_of[3, name]
            set = set (set == "" ? "" : ", ") name
        } else {
            print line[3, i]
        }
    }
    if (report == "") exit
    if (set != "") print "    set in: " set > report
    for (k = 1; k <= parts[2]; k++) {
        name = name_of[2, k]
        if (!wrote(name)) continue
        if (!fits(name))
            print "    " name ((3, name) in asked ? " asks for something else" : \
                " is gone") "; yours is in " kept > report
        else if ((1, name) in asked && asked[1, name] != asked[3, name])
            print "    the " (name ~ /^slot/ ? "contract" : "question") " of " \
                name " has changed: read it" > report
    }
}
