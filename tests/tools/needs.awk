# needs.awk - which objects is a program linked with?  Those whose headers it
# reaches.
#
#     grep -H '^#include "' SOURCES | awk -f tests/tools/needs.awk
#
# prints PROGRAM=OBJECT,OBJECT,... for each of the SOURCES that is a program's
# file, one on a line.  A header is named from common/ (linear/matrix.h), from
# the top of the tree, or from the folder of the file that includes it; its
# object is that of the C file beside it.

{
    file = $0
    sub(/:.*/, "", file)
    used = $0
    sub(/^[^"]*"/, "", used)
    sub(/".*/, "", used)
    if (!(file in count)) order[++n_file] = file
    include[file, ++count[file]] = used
}

function resolved(file, used,    folder) {
    folder = file
    sub(/[^\/]*$/, "", folder)
    if ((folder used) in is_header) return folder used
    if (("common/" used) in is_header) return "common/" used
    return used
}

# visit FILE, and the C file beside each header that it includes
function visit(file,    k, header, module) {
    if (file in seen) return
    seen[file] = 1
    for (k = 1; k <= count[file]; k++) {
        header = resolved(file, include[file, k])
        visit(header)
        module = header
        sub(/h$/, "c", module)
        if (module in count && !(module in seen)) {
            visit(module)
            sub(/c$/, "o", module)
            if (module ~ /^(common|figures)\//)
                list = list (list == "" ? "" : ",") module
        }
    }
}

END {
    # a file without a header of its own includes nothing that counts here
    for (k = 1; k <= n_file; k++) if (order[k] ~ /\.c$/) {
        header = order[k]
        sub(/c$/, "h", header)
        is_header[header] = 1
    }
    for (k = 1; k <= n_file; k++) if (order[k] ~ /\.h$/) is_header[order[k]] = 1
    for (k = 1; k <= n_file; k++) if (order[k] ~ /\.c$/) {
        split("", seen)
        list = ""
        visit(order[k])
        print order[k] "=" list
    }
}
