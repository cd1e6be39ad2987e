# seconds.awk - the tables of seconds in the chapter Speed, as `make bench` has
# measured them.  Behind bench.awk; the last file is the page, which is printed:
#
#     <!-- seconds NAME -->  ...  <!-- seconds end -->
#
# The names: step, rivals.  Nothing else writes there.
function digits(x) {
    if (x == "-") return "-"
    return sprintf(x >= 99.5 ? "%.0f" : x >= 9.95 ? "%.1f" : x >= 0.995 ? "%.2f" : \
        "%.3f", x)
}
function ratio(x) { return x == "-" ? x : sprintf(x >= 9.95 ? "%.0f" : "%.1f", x) }
function step(name, n) { return digits(of("step", "steps", name " " n, "median_ms")) }
function peer(method, n) { return of("peer", "peer", method " " n, "over_ours") }
function print_step(    n) {
    print "| $n$ | `readable` | `best` | `sparse` | `sparse`, kept factors |"
    print "|---:|---:|---:|---:|---:|"
    for (n = 8; n <= 128; n *= 2)
        print "| " n " | " step("readable", n) " | " \
            step("best", n) " | " step("sparse", n) " | " \
            digits(of("solvers", "solvers", "kept_single " n, "step_ms")) " |"
}
function print_rivals(    n, all, code) {
    print "| $n$ | strategy | code | both |"
    print "|---:|---:|---:|---:|"
    for (n = 8; n <= 128; n *= 2) {
        all = peer("notes", n)
        code = peer("method", n)
        print "| " n " | " ratio(over(all, code)) " | " ratio(code) " | " \
            ratio(all) " |"
    }
}
END {
    for (i = 1; i <= pages; i++) {
        if (page[i] == "<!-- seconds end -->") inside = 0
        if (!inside) print page[i]
        if (page[i] !~ /^<!-- seconds (step|rivals) -->$/) continue
        inside = 1
        rivals = page[i] ~ / rivals /
        if (rivals) print_rivals()
        else print_step()
        for (file in machine)
            if (file ~ (rivals ? "peer" : "speed.step")) where = machine[file]
        print "\n*" where (rivals ? "; " package : "") ".*"
    }
}
