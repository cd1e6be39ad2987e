# assembler.awk - a compiled program as the judge links it: no name of its own is
# the linker's.
#
#     awk [-v sanitized=1] -f tests/tools/assembler.awk WORDS CALLS PROGRAM.s
#
# Of the names that it defines those alone stay global by which the checks call it
# (contract.awk), so that it may have a function close(), which the judge does not
# get.  Refused is what does not stay inside: what runs before main(), and what
# could hide that, assembler and sections of its own; and what names one of the
# judge's WORDS without having it.  In a string all may stand.

FNR == 1 { file++ }
file == 1 { owner[$1] = $2; next }
file == 2 { keep["program_" $1]; next }

function refuse(why) {
    print "refused: " why > "/dev/stderr"
    refused = 1
    exit 1
}
{ text = $0 }
/"/ {
    gsub(/"([^"\\]|\\.)*"/, "", text)
    if (text ~ /"/) refuse("a section or a name has a line break in it")
}
# what gcc and clang write around assembler of the program's
/^[ \t]*[#\/;@]+ *(APP|InlineAsm Start|Start of file scope inline)/ { theirs = 1 }
/^[ \t]*[#\/;@]+ *(NO_APP|InlineAsm End|End of file scope inline)/ { theirs = 0 }
theirs && text !~ /^[ \t]*([#\/;@].*)?$/ { refuse("it has a line of assembler") }
text ~ /\.(incbin|include|macro|rept|irpc?|altmacro|pushsection|popsection|previous|symver)([ \t]|$)/ ||
text ~ /[;:].*\.(globl|global|weak|section|comm)/ {
    refuse("it has a line of assembler")
}
text ~ /indirect_function|IFUNC|mod_init_func|\.constructor/ ||
text ~ /\.section[ \t]+\.((pre)?init|ctors)/ && !sanitized {
    refuse("it has code that runs before main()")
}
text ~ /^[ \t]*\.section/ && $2 !~ /^("?\.note|(\.[ls]?(text|data|rodata|bss)|\.(tdata|tbss|debug_|eh_frame|toc))([.,]|$)|\.debug_|__(TEXT|DATA|DATA_CONST|LD|DWARF),)/ && !sanitized {
    refuse("it puts something into a section of the object file")
}
{ # its names, and the judge's
    n = split(text, word, /[^A-Za-z0-9_.$]+/)
    for (k = 1; k <= n; k++) if (owner[word[k]] == "judge") named[word[k]]
}
text ~ /^[A-Za-z_.$][A-Za-z0-9_.$]*:/ { has[substr(text, 1, index(text, ":") - 1)] }
{ name = $2; sub(/,.*/, "", name) }
$1 == ".set" || $1 == ".local" { has[name] }
$1 == ".comm" && !(name in has) { refuse("it asks for a common symbol") }
$1 ~ /^\.(globl|global|weak|weak_definition|private_extern|hidden|internal|protected)$/ {
    if ($1 == ".weak") weak[name]
    else if (owner[name] == "library") refuse("it has a function " name ", as the library has")
    sub(/^_/, "", name)
    if (name in keep) print
    next
}
{ print }
END {
    if (refused) exit 1
    for (name in weak) if (!(name in has)) print "\t.weak\t" name
    for (name in named)
        if (!(name in has)) refuse("it uses " name ", which is the judge's")
}
