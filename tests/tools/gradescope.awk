# gradescope.awk - the reports on a student's lessons as a results.json of
# Gradescope, tests/cli/gradescope.schema.json.
#
#     awk -f json.awk -f gradescope.awk REPORT...
#
# What was said stands beside each REPORT in a file `said`.  A lesson gives a
# point for each slot of its solution and one for the verdict OK.  A slot counts
# where a check of it passes, and it stands before the first slot that a failed
# check names; all count where the verdict is OK.

function point(name, points, text) {
    score += points
    tests = tests (tests == "" ? "" : ",") "\n    {\"name\": " string(name) \
        ", \"score\": " points ", \"max_score\": 1,\n     \"status\": \"" \
        (points ? "passed" : "failed") "\", \"visibility\": \"visible\",\n" \
        "     \"output\": " string(text) "}"
}

function end_lesson(   code_, slot, n, k, ok) {
    if (lesson == "") return
    code_ = contents("solutions/" lesson ".c")
    while (match(code_, /\/\* SLOT [0-9]+[a-z]/)) {
        slot[++n] = substr(code_, RSTART + 8, RLENGTH - 8)
        code_ = substr(code_, RSTART + RLENGTH)
    }
    ok = verdict == "OK"
    for (k = 1; k <= n; k++) {
        if (failed[slot[k]] || !passed[slot[k]]) break
        point(lesson ", slot " slot[k], 1, "")
    }
    for (; k <= n; k++)
        point(lesson ", slot " slot[k], ok ? 1 : 0, why[slot[k]])
    point(lesson ", the whole", ok ? 1 : 0, verdict)
    output = output contents(said) "\n"
    split("", failed)
    split("", passed)
    split("", why)
}

FNR == 1 {
    end_lesson()
    lesson = $1
    verdict = $3
    said = FILENAME
    sub(/report$/, "said", said)
    next
}
$2 == "passed" { passed[$3] = 1 }
$2 != "passed" { failed[$3] = 1; why[$3] = why[$3] $1 ": " $2 ". " $7 "\n" }
END {
    end_lesson()
    print "{\n  \"score\": " score + 0 ",\n  \"visibility\": \"visible\","
    print "  \"output\": " string(output) ",\n  \"tests\": [" tests "\n  ]\n}"
}
