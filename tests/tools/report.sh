# report.sh - verdicts for machines, for scripts that read this file with `.`.
# A report is what write_report() of tests/checks/judging.h writes.

# report SLUG FILE VERDICT CHECK NEXT: a report without the judge, of the message
# on stdin.
report() {
    printf '%s\037' "$1" "$2" "$3" "$4" '' '' "$5"
    printf '%s\036' "$(tr -d '\000\036\037')"
}

# Nothing that a program said reaches a terminal but text.
harmless() { tr '\000-\010\013-\037\177' '[?*]'; }

# Of the file that is called $shown, in $folder, when the judge is not asked:
# verdict SHOWN RESULT NEXT: what $folder/why says, and the closing line, which is
# remembered for hint and status.
verdict() {
    harmless <"$folder/why"
    echo "$2" >"$folder/result"
    echo "VERDICT $nn: $1    next: $3"
    failed=${2#* } failed=${failed%% *}
    report "$slug" "$shown" "${2%% *}" "${failed#-}" "$3" \
        <"$folder/why" >"$folder/report"
}
# no_verdict NEXT: there is none; $folder/why says it, on stderr.
no_verdict() {
    harmless <"$folder/why" >&2
    rm -f "$folder/result"
    report "$slug" "$shown" 'not judged' '' "$1" <"$folder/why" >"$folder/report"
    return 2
}

# json REPORT: the report as JSON.
json() {
    slug_=$(tr '\037' '\n' <"$1" | head -n 1)
    MISTAKES=$BUILD/mistakes/$slug_ awk -f tests/tools/json.awk \
        -f tests/tools/verdict.awk "$1"
}

# What JSON=FILE names: a file is written beside it, $part, and renamed.  An old
# one goes at once.  A device, or a descriptor like /dev/fd/3, is written to.
json_begin() {
    case $JSON in '' | /dev/*) return ;; esac
    part=$JSON.$$.part
    [ ! -d "$JSON" ] && { rm -f "$JSON" && true >"$part"; } 2>/dev/null && return
    echo "JSON=$JSON cannot be written." >&2
    exit 2
}
json_end() { # json_end REPORT
    case $JSON in
    '') ;;
    /dev/*) json "$1" >>"$JSON" ;;
    *) json "$1" >"$part" && mv "$part" "$JSON" ;;
    esac
}
