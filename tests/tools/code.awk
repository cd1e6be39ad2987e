# code.awk - the slots of a solution, each in a fold of its own, for the page of its
# hints and answers in the book as HTML.
#
#     awk -f tests/tools/code.awk solutions/NN_slug.c

/\/\* END [0-9]+[a-z] \*\// && slot != "" {
    print "```\n\n</details>"
    slot = ""
}
slot != "" && !comment {
    if (!lines++) { match($0, /^ */); indent = RLENGTH }
    print substr($0, 1, indent) ~ /^ *$/ ? substr($0, indent + 1) : $0
}
match($0, /\/\* SLOT [0-9]+[a-z]\(/) {
    slot = substr($0, RSTART + 8, RLENGTH - 9)
    lines = 0
    comment = 1
    print "\n<a id=\"code-" slot "\"></a>"
    print "<details><summary>Code of slot " slot "</summary>\n\n```c"
}
comment && /\*\// { comment = 0 }
