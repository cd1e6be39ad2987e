# note.awk - what is unusual in a program, for whoever marks it: no verdict asks.
#
#     nm -gP libworkbook.a | awk -f tests/tools/note.awk - SOLUTION.s PROGRAM.s PROGRAM.d
#
# names the functions and data of the library that the program refers to and the
# solution does not (one may be what a slot teaches), and headers that no lesson needs.

FNR == 1 { file = FILENAME == "-" ? "names" : file == "solution" ? "program" : \
               FILENAME ~ /\.s$/ ? "solution" : "headers" }
file == "names" {
    if ($2 ~ /^[TDRB]$/ && $1 !~ /^(todo|die|allocate|cell_|options_|status_|table_)/)
        library[$1]
    next
}
file == "headers" {
    for (k = 1; k <= NF; k++)
        if ($k ~ /\/(unistd|dlfcn|setjmp|signal|fcntl|spawn|link|elf|execinfo|dirent|ftw|sys\/(auxv|ipc|mman|prctl|ptrace|resource|shm|socket|stat|syscall|wait))\.h$/) {
            sub(/.*\/include\/([^\/]*-[^\/]*\/)?/, "", $k)
            if (!told[$k]++) headers = headers ", " $k
        }
    next
}
!/"/ {
    n = split($0, word, /[^A-Za-z0-9_]+/)
    for (k = 1; k <= n; k++) {
        if (!(word[k] in library)) continue
        if (file == "solution") known[word[k]]
        else if (!(word[k] in known) && !told[word[k]]++) calls = calls ", " word[k]
    }
}
END {
    if (headers) print "Headers that no lesson needs: " substr(headers, 3)
    if (calls) print "Names of the library that the solution does without: " substr(calls, 3)
}
