# show.awk - named tables for the eye: aligned, six digits, eight rows each.
/^#/ && !rows { if (!named) print "\n" substr($0, 3); else print "  (" substr($0, 3) ")"
                named = 1; next }
NF == 0 { if (rows > 9) printf "  ... %d rows more\n", rows - 9
          rows = named = 0; next }
{
    rows++
    if (rows > 9) next
    line = ""
    n = split($0, field, "\t")
    for (i = 1; i <= n; i++)
        line = line sprintf(rows == 1 ? "%14s" : "%14.6g", field[i])
    print substr(line, 1, 100)
}
