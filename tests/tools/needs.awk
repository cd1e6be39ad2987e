# needs.awk - which objects is a program linked with?  Those whose headers it
# reaches.
#
#     grep -H '^#include "' SOURCES | awk [-v asked=FILES] -f tests/tools/needs.awk
#
# prints PROGRAM=OBJECT,OBJECT,... for each of the SOURCES that is a program's
# file, one on a line; or for those of the FILES alone.  A header is named from
# common/ (linear/matrix.h), from the top of the tree, or from the folder of the
# file that includes it (../ is the one above); its object is that of the C file
# beside it.

BEGIN { FS = "\"" }
{
    file = substr($1, 1, index($1, ":") - 1)
    if (!(file in count)) order[++n_file] = file
    include[file, ++count[file]] = $2
}

function resolved(file, used) {
    sub(/[^\/]*$/, "", file)
    while (sub(/^\.\.\//, "", used)) sub(/[^\/]*\/$/, "", file)
    if ((file used) in is_header) return file used
    if (("common/" used) in is_header) return "common/" used
    return used
}

# visit FILE for PROGRAM, and the C file beside each header that it includes
function visit(program, file,    k, header, module) {
    if (seen[file] == program) return
    seen[file] = program
    for (k = 1; k <= count[file]; k++) {
        header = include[file, k]
        visit(program, header)
        module = beside[header]
        if (module == "" || seen[module] == program) continue
        visit(program, module)
        if (module in object)
            list = list (list == "" ? "" : ",") object[module]
    }
}

END {
    # a file without a header of its own includes nothing that counts here
    for (k = 1; k <= n_file; k++) {
        file = header = order[k]
        if (sub(/\.c$/, ".h", header)) {
            beside[header] = file
            if (file ~ /^(common|figures|lessons)\//)
                object[file] = substr(header, 1, length(header) - 1) "o"
        }
        is_header[header]
    }
    for (k = 1; k <= n_file; k++)
        for (i = 1; i <= count[order[k]]; i++)
            include[order[k], i] = resolved(order[k], include[order[k], i])
    n_asked = split(asked, name, " ")
    for (k = 1; k <= n_asked; k++) is_asked[name[k]]
    for (k = 1; k <= n_file; k++) {
        if (order[k] !~ /\.c$/ || (n_asked && !(order[k] in is_asked))) continue
        list = ""
        visit(order[k], order[k])
        print order[k] "=" list
    }
}
