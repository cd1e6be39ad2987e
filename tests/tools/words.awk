# words.awk - the names that are the linker's already, before a judged program comes.
#
#     { nm -gP JUDGE && echo library && nm -gP OTHERS; } | awk -f tests/tools/words.awk
#
# prints "NAME judge" or "NAME library" for each that is defined there.

BEGIN { print "-" }
NF == 1 { theirs = theirs || $1 == "library" }
$2 ~ /[A-TV-Z]/ { print $1, theirs ? "library" : "judge" }
