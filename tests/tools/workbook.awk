# workbook.awk - fill the numbers and tables of one file of the book.
#
#     awk -f tests/tools/workbook.awk -v data=build/data \
#         -v table=../workbook.md lessons/NN_slug.md
#
# SOURCE is NN_slug, what a solution prints by default, or NN_slug/what, what the
# study figures/NN_slug/what.c prints: data/SOURCE.tsv.  What stands between
# these markers is replaced:
#
#   <!-- table SOURCE TABLE; COLUMN FORMAT HEADING; ... -->    a whole table
#   <!-- end -->
#   <!-- n SOURCE TABLE COLUMN ROW FORMAT -->85375<!-- /n -->   in a line;
#       rows count from 0, -1 is the last
#
#   <!-- labels -->              behind the text, by itself: what makes a link of
#   <!-- end -->                 every [eq:name] in it, to its row in the file
#                                `table`, "" for this one, which has an anchor; of
#                                an [alg:name] to its lines, where `lines`,
#                                "alg-name FILE ...", has the chapter with them
#
# The line "Previous: ..." of a chapter is replaced by `leading`, if there is one.
# `minutes` is "01 115 02 140 ...", and sums of lessons are filled in as hours:
#
#   <!-- hours 1-2 9 11-13 -->13<!-- /hours -->
#
# FORMAT is that of printf; 1.5e+03 is written 1.5·10³, and 0.2 by %.0f%% 20 %.  A
# cell that is no number (a word, or - where there is none) stands as it is, whatever
# its FORMAT.  Columns stand on the right, those without a number on the left.
# To be run with LC_ALL=C: mawk takes the decimal point from the locale.

BEGIN {
    for (i = split("⁰ ¹ ² ³ ⁴ ⁵ ⁶ ⁷ ⁸ ⁹", digit_list, " "); i > 0; i--)
        superscript[i - 1] = digit_list[i]
    for (i = split(lines, place, " "); i > 0; i -= 2) chapter[place[i - 1]] = place[i]
}

function stop(text) {
    print "workbook: " FILENAME ", line " FNR ": " text > "/dev/stderr"
    failed = 1
    exit 2
}

# Read a program's tables once: value[source, table, column, row], rows[...].
function load(source,    path, line, name, n, c, word, column, status) {
    if (source in loaded) return
    loaded[source] = 1
    path = data "/" source ".tsv"
    while ((status = (getline line < path)) > 0) {
        if (line == "") { name = ""; continue }
        if (line ~ /^#/) {
            if (name == "") { name = substr(line, 3); n = -1; split("", column) }
            continue
        }
        c = split(line, word, "\t")
        if (n < 0) { for (; c > 0; c--) column[c] = word[c] }
        else for (; c > 0; c--) value[source, name, column[c], n] = word[c]
        n++
        rows[source, name] = n
    }
    if (status < 0) stop("cannot read " path)
    close(path)
}

function raw(source, table, column, row) {
    load(source)
    if (row < 0) row += rows[source, table]
    if (!((source, table, column, row) in value))
        stop("no cell " source " " table " " column " row " row)
    return value[source, table, column, row] ""
}
function is_number(text) {
    return text ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/
}
function cell(source, table, column, row, format,    text) {
    text = raw(source, table, column, row)
    if (!is_number(text)) return text
    if (sub(/%%$/, " %%", format)) text *= 100
    if (format !~ /%[-0-9.]*s/) text = sprintf(format, text + 0)
    else text = sprintf(format, text)
    sub(/^-0(\.0*)?$/, "0&", text) # a rounded -1e-17 is 0
    sub(/^0-0/, "0", text)
    return powers(text)
}

# 1.5e+03 as one writes it: 1.5·10³.  No match() here: the caller needs RSTART.
function powers(text,    part, power, raised, i) {
    if (split(text, part, "e") != 2 || part[2] !~ /^[-+][0-9]+$/) return text
    power = part[2] + 0
    if (power == 0) return part[1]
    raised = power < 0 ? "·10⁻" : "·10"
    if (power < 0) power = -power
    for (i = 1; i <= length(power ""); i++)
        raised = raised superscript[substr(power, i, 1)]
    return part[1] raised
}

function print_table(spec,    part, n, i, word, k, row, head, rule, line, numbers) {
    n = split(spec, part, / *; */)
    split(part[1], word, " ")
    load(word[1])
    if (!((word[1], word[2]) in rows)) stop("no table " word[2] " in " word[1])
    for (i = 2; i <= n; i++) {
        k = split(part[i], column, " ")
        name[i] = column[1]; format[i] = column[2]
        head = head " |"
        for (j = 3; j <= k; j++) head = head " " column[j]
        numbers = 0
        for (row = 0; row < rows[word[1], word[2]]; row++)
            numbers += is_number(raw(word[1], word[2], name[i], row))
        rule = rule (numbers ? "|---:" : "|---")
    }
    print substr(head, 2) " |"
    print rule "|"
    for (row = 0; row < rows[word[1], word[2]]; row++) {
        line = ""
        for (i = 2; i <= n; i++)
            line = line "| " cell(word[1], word[2], name[i], row, format[i]) " "
        print line "|"
    }
}

# Remember the labels that a line of text cites.
function cite(text,    label) {
    while (match(text, /\[(eq|alg):[A-Za-z0-9-]+\]/)) {
        label = substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, RSTART + RLENGTH)
        if (text ~ /^\([^)#]*#answer-/) continue # it leads to an answer
        if (!(label in cited)) { cited[label] = 1; order[++n_cited] = label }
    }
}

# A row of the equations gets its anchor.
function anchored(row,    label) {
    match(row, /\[[^]]*\]/)
    label = substr(row, RSTART + 1, RLENGTH - 2)
    row = substr(row, RSTART + RLENGTH)
    cite(row)
    return "| <a id=\"" id(label) "\"></a>[" label "]" row
}
function id(label) { sub(/:/, "-", label); return label }
# Where a label leads to.
function aim(name,    up) {
    if (!(name in chapter)) return table "#" name
    if (chapter[name] == FILENAME) return "#" name
    up = table
    sub(/workbook\.md$/, "", up)
    up = up chapter[name] "#" name
    if (FILENAME ~ /^lessons\//) sub(/^\.\.\/lessons\//, "", up)
    return up
}

# The sum of the minutes of lessons, "1-2 9", in whole hours.
function hours(lessons,    n, k, i, part, range, each, sum) {
    n = split(minutes, each, " ")
    k = split(lessons, part, " ")
    for (; k > 0; k--) {
        split(part[k] "-" part[k], range, "-")
        for (i = 1; i < n; i += 2)
            if (each[i] + 0 >= range[1] + 0 && each[i] + 0 <= range[2] + 0)
                sum += each[i + 1]
    }
    return int(sum / 60 + 0.5)
}

# the line that leads to the neighbours, and hours; with only=lead the rest stays
leading != "" && /\| next: |^Previous: / && !/^ *</ { print leading; next }
minutes != "" && /<!-- hours [^>]*-->/ {
    spec = $0
    sub(/.*<!-- hours /, "", spec)
    sub(/ *-->.*/, "", spec)
    match($0, /<!-- hours [^>]*-->[^<]*/)
    $0 = substr($0, 1, RSTART - 1) "<!-- hours " spec " -->" hours(spec) \
        substr($0, RSTART + RLENGTH)
}
only == "lead" || only == "led" { print; next }
/^<!-- labels -->$/ {
    skipping = labels = 1
    next
}
/^<!-- table .* -->$/ {
    print
    gsub(/^<!-- table +| *-->$/, "")
    print_table($0)
    skipping = 1
    next
}
/^<!-- end -->$/ {
    if (!skipping) stop("an end without a beginning")
    skipping = 0
    if (labels) { labels = 0; next }
}
skipping { next }
/^ *```/ { fence = !fence }
!fence && table == "" && /^\| (<a id="[^"]*"><\/a>)?\[(eq|alg):[A-Za-z0-9-]+\] \|/ {
    $0 = anchored($0)
}
{
    line = $0
    if (!fence && line !~ /^\| <a id="/) {
        text = line
        gsub(/`[^`]*`/, "", text)
        cite(text)
    }
    blank = line == ""
    while (match(line, /<!-- n [^>]*-->[^<]*<!-- \/n -->/)) {
        spec = substr(line, RSTART, RLENGTH)
        open = spec; sub(/-->.*/, "-->", open)
        split(open, word, " ")
        printf "%s%s%s<!-- /n -->", substr(line, 1, RSTART - 1), open, \
            cell(word[3], word[4], word[5], word[6] + 0, word[7])
        line = substr(line, RSTART + RLENGTH)
    }
    print line
}
END {
    if (failed) exit 2
    if (only == "lead" || only == "led") exit
    if (skipping) stop("a marker is never closed")
    if (!n_cited) exit
    if (!blank) print ""
    print "<!-- labels -->"
    for (i = 1; i <= n_cited; i++)
        print "[" order[i] "]: " aim(id(order[i]))
    print "<!-- end -->"
}
