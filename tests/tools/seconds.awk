# seconds.awk - the tables of seconds in the chapter Speed, as `make bench` has
# measured them.  Behind bench.awk; the last file is the page, which is printed:
#
#     <!-- seconds NAME -->  ...  <!-- seconds end -->
#
# The names: step, strategy, elements.  Nothing else writes there.
function digits(x) {
    if (x == "-") return "-"
    return sprintf(x >= 99.5 ? "%.0f" : x >= 9.95 ? "%.1f" : x >= 0.995 ? "%.2f" : \
        "%.3f", x)
}
function step(name, n) { return digits(of("step", "steps", name " " n, "median_ms")) }
function peer(method, n, column) { return of("peer", "peer", method " " n, column) }
function print_step(    n, name) {
    print "| $n$ | `readable` | PETSc, `notes` | `blocked` | `best` | " \
        "PETSc, `method` | `sparse` | " \
        "`sparse`, factors kept across steps, single precision |"
    print "|---:|---:|---:|---:|---:|---:|---:|---:|"
    for (n = 8; n <= 128; n *= 2)
        print "| " n " | " step("readable", n) " | " \
            digits(peer("notes", n, "step_ms")) " | " step("blocked", n) " | " \
            step("best", n) " | " \
            digits(peer("method", n, "step_ms")) " | " step("sparse", n) " | " \
            digits(of("solvers", "solvers", "kept_single " n, "step_ms")) " |"
}
function print_strategy(    n, all, code) {
    print "| $n$ | PETSc, `notes` | PETSc, `method` | " \
        "ours: `best`, from $n=36$ on `sparse` | " \
        "kept: across steps, from $n=36$ on in single precision | " \
        "strategy (`notes` over `method`) | code (`method` over ours) | " \
        "both | both, with kept factors |"
    print "|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
    for (n = 8; n <= 128; n *= 2) {
        all = peer("notes", n, "over_ours")
        code = peer("method", n, "over_ours")
        print "| " n " | " digits(peer("notes", n, "step_ms")) " | " \
            digits(peer("method", n, "step_ms")) " | " \
            digits(peer("ours", n, "step_ms")) " | " \
            digits(peer("kept", n, "step_ms")) " | " \
            digits(over(all, code)) " | " digits(code) " | " \
            digits(all) " | " digits(peer("notes", n, "over_kept")) " |"
    }
}
function cells(scene, error, kind,    key) {
    key = scene " " error " " kind
    return digits(of("seconds", "elements", key, "fewer")) " | " \
        digits(of("seconds", "elements", key, "faster"))
}
function print_elements(    s, e, scene, error, linear) {
    split("weight column", scene, " ")
    split("0.01 0.003", error, " ")
    print "| scene | error | linear, Mflop | ms | $m=1.5$: times fewer flops | " \
        "times faster | quadratic: times fewer | times faster | " \
        "quadratic, $m=2$: times fewer | times faster |"
    print "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
    for (s = 1; s <= 2; s++)
        for (e = 1; e <= 2; e++) {
            linear = scene[s] " " error[e] " linear 1"
            print "| " scene[s] " | " error[e] " | " \
                digits(1e-6 * of("seconds", "elements", linear, "flops")) " | " \
                digits(of("seconds", "elements", linear, "ms")) " | " \
                cells(scene[s], error[e], "linear 1.5") " | " \
                cells(scene[s], error[e], "quadratic 1") " | " \
                cells(scene[s], error[e], "quadratic 2") " |"
        }
}
END {
    for (i = 1; i <= pages; i++) {
        if (page[i] == "<!-- seconds end -->") inside = 0
        if (!inside) print page[i]
        if (page[i] !~ /^<!-- seconds [a-z]+ -->$/ || page[i] ~ / end /) continue
        inside = 1
        if (page[i] ~ / step /) print_step()
        else if (page[i] ~ / strategy /) print_strategy()
        else if (page[i] ~ / elements /) print_elements()
        for (file in machine)
            if (file ~ /speed.step/ && page[i] !~ / elements /)
                where = machine[file] "; " package
            else if (file ~ /25_elements/ && page[i] ~ / elements /)
                where = machine[file]
        print "\n*" where ".*"
    }
}
