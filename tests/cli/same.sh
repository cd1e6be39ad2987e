#!/bin/sh
# same.sh - tests/tools/same.awk finds what differs between two tables, and
# nothing else.  Prints ok and FAIL lines.
set -u
LC_ALL=C
export LC_ALL
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
printf '%b' '# one\nn\tword\tx\terror\tlate\n8\tOK\t250.25\t3e-15\t2.385e+00\n' \
    '16\t-\t0.5\t1.5234567e-05\t-1.2e-03\n\n\n# two\n# n = 4\ni\n1\n2\n\n\n' >"$tmp/one"
# case_of SAYS WHAT SCRIPT: of tables that sed's SCRIPT has changed same.awk says
# SAYS; an empty one: nothing
case_of() {
    sed "$3" "$tmp/one" >"$tmp/other"
    said=$(awk -f tests/tools/same.awk "$tmp/one" "$tmp/other")
    status=$?
    if cmp -s "$tmp/one" "$tmp/other"; then said="no case: $3"; fi
    if [ -z "$1" ]; then [ $status = 0 ] && [ -z "$said" ]
    else [ $status = 1 ] && case $said in "$1"*) ;; *) false ;; esac fi
    if [ $? = 0 ]; then echo "ok same: $2"
    else echo "FAIL same: $2: status $status, $said"; fi
}
case_of '' 'round-off of the scale of a column' 's/0\.5/0.50000000000000011/'
case_of '' 'nine digits of the scale of a column' 's/0\.5/0.5000002/'
case_of '' 'round-off of a residual' 's/3e-15/9e-15/'
case_of '' 'the last digit of a rounded number' 's/2.385e/2.386e/'
case_of '' 'the last digit of a negative one' 's/-1\.2e/-1.1e/'
case_of 'one x row 0' 'a digit' 's/250\.25/250.2500003/'
case_of 'one x row 1' 'a digit of a small one' 's/0\.5/0.5000003/'
case_of 'one error row 1' 'an error' 's/1\.52/1.53/'
case_of 'one late row 0' 'two of the last digit' 's/2.385e/2.387e/'
case_of 'one late row 0' 'another power' 's/2.385e+00/2.385e-01/'
case_of 'one late row 1' 'a sign' 's/-1\.2e/1.2e/'
case_of 'one n row 1' 'a whole number' 's/16/17/'
case_of 'two i row 1' 'a whole number of another table' 's/^2$/3/'
case_of 'one word row 0' 'a word' 's/OK/NOT_SPD/'
case_of 'one word row 1' 'a number where there is none' 's/16.-/16	3/'
case_of 'one x row 0' 'a NaN' 's/250\.25/nan/'
case_of 'one line 2' 'a column' 's/late/early/'
case_of 'two line 8' 'a comment' 's/n = 4/n = 5/'
case_of 'three line 7' 'a table' 's/two/three/'
case_of 'two i row 0' 'a missing row' '/^1$/d'
case_of 'end' 'lines at the end' '$d'
