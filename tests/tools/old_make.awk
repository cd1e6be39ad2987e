# old_make.awk - what GNU make 3.81 to 4.2 cannot read in a makefile.
#
#     awk -f tests/tools/old_make.awk FILES
#
# Prints "FILE:LINE: what".  These end a line at a # within a function, where a
# variable `hash` has to stand for it; 3.81, which macOS has, may crash where a
# variable is changed while it is expanded, and does not know what came later.

FNR == 1 { depth = 0 }
/^\t/ || (/^ *#/ && !depth) { next }
$2 == "=" && $3 == "$(eval" && $4 == $1 { print FILENAME ":" FNR ": " $1 " changes itself" }
/^(define +[^ ]+ *[:+?]*=|undefine |private )/ || /^[A-Za-z_0-9]+ *(!|::)=/ ||
/\$\((file|guile|let|intcmp) / { print FILENAME ":" FNR ": came later" }
{
    for (k = 1; k <= length($0); k++) {
        c = substr($0, k, 1)
        if (c == "(" && (depth || substr($0, k - 1, 1) == "$")) depth++
        if (c == ")" && depth) depth--
        if (c == "#" && depth) print FILENAME ":" FNR ": # within a function"
    }
    if (!/\\$/) depth = 0
}
