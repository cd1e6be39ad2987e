#!/bin/sh
# json.sh - the verdicts for machines: `make check-NN JSON=file`, whatever becomes
# of a file.  Prints "ok ...", "FAIL ..." or "skip ..." lines.
set -u
LC_ALL=C
export LC_ALL
: "${BUILD:=build}" "${MAKE:=make}"
slug=03_dirichlet_correction
mine=lessons/$slug.c
result() { # result STATUS WHAT WHY
    if [ "$1" = 0 ]; then printf 'ok cli: %s\n' "$2"
    else printf 'FAIL cli: %s: %s\n' "$2" "$3"; fi
}
copy=$BUILD/test/copy.json
BUILD="$BUILD" sh tests/tools/copy.sh "$copy" $slug || exit 1
cd "$copy" || exit 1
variant() {
    awk -f tests/tools/variant.awk -v name="$1" "tests/mistakes/$slug.txt" \
        "solutions/$slug.c"
}
schema=$(python3 -c 'import jsonschema' 2>/dev/null && echo tests/cli/verdict.schema.json)
follows() { [ -z "$schema" ] || python3 tests/tools/schema.py "$schema" "$1" 2>&1; }
mkdir "it's here"
json="it's here/verdict.json"

# says WHAT STATUS TEXT...: my file has a verdict that keeps to the schema, has
# these texts, and the line VERDICT its word
says() {
    what=$1 wanted=$2
    shift 2
    echo old >"$json"
    "$MAKE" check-03 BUILD=build JSON="$json" >said 2>&1
    status=$?
    wrong=$(follows "$json")
    [ $status = "$wanted" ] && [ -z "$wrong" ]
    result $? "a file that $what has its JSON" "status $status, $wrong $(cat said)"
    for text in "$@"; do
        grep -qF -e "$text" "$json"
        result $? "the JSON of a file that $what: $text" "$(cat "$json")"
    done
    word=$(sed -n 's/^VERDICT 03: \([A-Z]*\).*/\1/p' said)
    grep -qF "\"verdict\": \"${word:-not judged}\"" "$json"
    result $? "the JSON of a file that $what has the word of the verdict" "$word"
}
cp "solutions/$slug.c" $mine
says 'is right' 0 '"check": null' '"next": null' '"status": "passed"'
variant lift_sign >$mine
says 'is wrong' 2 '"check": "known_values_move_to_the_right"' '"slot": "3a"' \
    '"got": 1.200250' '"allowed": 9.99' '{"name": "lift_sign", "why": "added A' \
    '"next": "make hint-03"' '"status": "failed"' \
    "\`b_corrected\`, row 6 (i = 5), column \`value\`: yours" '"got": -2989.096'
cp $mine other.c && cp "$json" wrong.json
variant "$(awk '/^mistake: / { name = $2 } /^verdict: NONFINITE/ { print name; exit }' \
    "tests/mistakes/$slug.txt")" >$mine
says 'is not finite' 2 '"verdict": "NONFINITE"'
awk -f tests/tools/starter.awk "solutions/$slug.c" >$mine
says 'is not written' 2 '"slot": "3a"' 'slot 3a is not written yet'
{ sed 's/^int main.*/int x = "\\" \\q "\\377"; \
&/' "solutions/$slug.c"; printf 'int \303\251\377\033;\n'; } >$mine
says 'does not compile' 2 '"check": "compile"' '"next": "make check-03"' \
    '"checks": []' "  $mine:"
: >$mine
says 'is empty' 2 'is empty.' '"next": "make reset-03"'
rm $mine
says 'is not there' 2 'is not there.'
printf '\377\376/\000*\000' >$mine
says 'is in UTF-16' 2 'is in UTF-16.'
echo "#include \"../solutions/$slug.c\"" >$mine
says 'includes a solution' 2 'it includes what is no header'
sed '/SLOT 3a/i\
    raise(SIGKILL);
1i\
#include <signal.h>' "solutions/$slug.c" >$mine
says 'crashes' 2 '"verdict": "CRASHED"'
cp other.c $mine
cp "tests/checks/$slug.c" checks
echo 'int "' >>"tests/checks/$slug.c"
says 'cannot be judged' 2 '"verdict": "not judged"' '"next": "make deps"'
cp checks "tests/checks/$slug.c"

# ---- where it is written --------------------------------------------------------
"$MAKE" check-03 BUILD=build JSON="it's here" >said 2>&1
[ $? != 0 ] && [ -d "it's here" ] && grep -q 'cannot be written' said
result $? 'JSON= refuses a folder' "$(cat said)"
"$MAKE" check-03 BUILD=build JSON=no/such/file >said 2>&1
[ $? != 0 ] && grep -q 'cannot be written' said && ! grep -q VERDICT said
result $? 'JSON= refuses a folder that is not there' "$(cat said)"
"$MAKE" check-03 BUILD=build JSON=/dev/fd/7 7>third >/dev/null 2>&1
cmp -s third wrong.json
result $? 'JSON= writes to a descriptor' "$(diff third wrong.json)"
"$MAKE" check-03 BUILD=build JSON=/dev/stdout >said 2>/dev/null
sed '1,/^VERDICT/d' said | sed '/^make/d' | cmp -s - wrong.json
result $? 'JSON=/dev/stdout comes after the verdict' "$(cat said)"
[ "$(ls "it's here")" = verdict.json ]
result $? 'JSON= leaves one file' "$(ls "it's here")"

# ---- strings --------------------------------------------------------------------
printf '%s\037' $slug "$(printf '"q" \\ \t \033 \177 \303\251 \360\237\230\200')" WRONG '' \
    '' '' '' >report
printf '%s\036' "$(printf '\377 \303 \355\240\200 \300\257 \360\202\202\254 \n |')" \
    "$(printf 'c\037failed\037\037nan\0371e-05\037.5\037')" >>report
BUILD=build MISTAKES='' awk -f tests/tools/json.awk -f tests/tools/verdict.awk report >odd
u='\ufffd'
for text in '"file": "\"q\" \\ \u0009 \u001b \u007f '"$(printf '\303\251 \360\237\230\200"')" \
    "\"$u $u $u$u$u $u$u $u$u$u$u \\n |\"" '"got": "nan", "want": 1e-05, "allowed": ".5"'; do
    grep -qF -e "$text" odd && [ -z "$(follows odd)" ]
    result $? "a string of JSON: $text" "$(follows odd) $(cat odd)"
done

# ---- what the schema notices ------------------------------------------------------
spoilt() { # spoilt WHAT: spoilt.json is
    ! cmp -s spoilt.json wrong.json && ! follows spoilt.json >why
    result $? "the schema refuses $1" "$(cat why)"
}
if [ -n "$schema" ]; then
    sed 's/"slot": [^,]*,$//' wrong.json >spoilt.json
    spoilt 'a missing key of a check'
    sed 's/"verdict": "WRONG"/"verdict": "BAD"/' wrong.json >spoilt.json
    spoilt 'a verdict that there is not'
    sed 's/c == "\\"" ||//' tests/tools/json.awk >json.awk
    MISTAKES='' awk -f json.awk -f tests/tools/verdict.awk report >spoilt.json
    spoilt 'quotes that are not escaped'
else
    echo 'skip json: no python3-jsonschema here'
fi
cd - >/dev/null && rm -rf "$copy"
