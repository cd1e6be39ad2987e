# parameters.awk - parameters of awk functions that have the name of a function of
# the same file, which POSIX, and so gawk --posix, does not allow.
#
#     awk -f tests/tools/parameters.awk FILES

FNR == 1 { tell() }
/^function / {
    split($0, part, /[(]|[)]/)
    name = substr(part[1], 10)
    is_function[name]
    n = split(part[2], list, / *, */)
    for (k = 1; k <= n; k++) of[list[k]] = of[list[k]] " " name "()"
    file = FILENAME
}
END { tell() }
function tell(    parameter) {
    for (parameter in of)
        if (parameter in is_function)
            print file ": " parameter " of" of[parameter]
    split("", of)
    split("", is_function)
}
