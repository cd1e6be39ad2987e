# verdict.awk - a report as the JSON of tests/cli/verdict.schema.json.
#
#     awk -f json.awk -f verdict.awk REPORT
#
# In the environment: MISTAKES, the folder with what is known of them, and
# JSON_STUDENT, who is named first where there is one.

function named(names,   n, k, name, why, text) {
    n = split(names, name, ",")
    for (k = 1; k <= n; k++) {
        why = contents(ENVIRON["MISTAKES"] "/" name[k] ".why")
        sub(/^[^ \n]*[ \n]+/, "", why) # the check that catches it
        gsub(/\n/, " ", why)
        sub(/ +$/, "", why)
        text = text (k > 1 ? ", " : "") "{\"name\": " string(name[k]) \
               ", \"why\": " string_or_null(why) "}"
    }
    return text
}

NR == 1 {
    print "{"
    if (ENVIRON["JSON_STUDENT"] != "")
        print "  \"student\": " string(ENVIRON["JSON_STUDENT"]) ","
    print "  \"lesson\": " string($1) ","
    print "  \"file\": " string($2) ","
    print "  \"verdict\": " string($3) ","
    print "  \"check\": " string_or_null($4) ","
    print "  \"slot\": " string_or_null($5) ","
    print "  \"mistakes\": [" named($6) "],"
    print "  \"next\": " string_or_null($7) ","
    print "  \"message\": " string_or_null($8) ","
    printf "  \"checks\": ["
}
NR > 1 {
    printf "%s\n    {\"claim\": %s, \"status\": %s, \"slot\": %s,\n", \
        (NR > 2 ? "," : ""), string($1), string($2), string_or_null($3)
    printf "     \"got\": %s, \"want\": %s, \"allowed\": %s,\n", \
        value($4), value($5), value($6)
    printf "     \"message\": %s}", string_or_null($7)
}
END { print (NR > 1 ? "\n  " : "") "]\n}" }
