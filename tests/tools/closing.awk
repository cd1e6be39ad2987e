# closing.awk - the closing table of `make bench`: what was wanted, what was
# measured here, and whether it was met.  Behind bench.awk.
#
# processor: the seconds of the processor that the studies had, by the seconds
# that went by; one thread on a quiet machine has nearly all of them.

# goal > 0: at least; < 0: at most; 0: none
function line(what, goal, got,    met, wanted, here, word) {
    met = got == "-" || goal == 0 ? "" : goal > 0 ? got >= goal : got <= -goal
    wanted = goal == 0 ? "-" : (goal > 0 ? ">= " goal : "<= " (-goal))
    here = got == "-" ? "-" : sprintf("%.4g", got)
    word = met == "" ? "-" : met ? "yes" : "NO"
    printf "  %-58s %9s %9s  %s\n", what, wanted, here, word
}
function kept(key, name) { return of("kept", "kept", key, name) }
function peer(method, n) { return of("peer", "peer", method " " n, "over_ours") }
function sweep(solver) { return of("chart", "large", solver " 1000000", "ns_per_unknown") }
function mean(a, b) { return a == "-" || b == "-" ? "-" : (a + b) / 2 }
# Exponent from n = 64 to 256, of its two doublings.
function growth(solver, to) {
    return mean(of("solvers", "growth", solver, to "128"), \
        of("solvers", "growth", solver, to "256"))
}
END {
    gsl = lapack = rival = band = notes = worst = late = "-"
    for (n = 32; n <= 128; n *= 2) {
        gsl = least(gsl, of("band", "band", "gsl_banded " n, "over_ours"))
        lapack = least(lapack, of("band", "band", "lapack_dpbtrf " n, "over_ours"))
    }
    for (n = 32; n <= 256; n *= 2) rival = least(rival, gain("dissection", "cholmod", n))
    for (n = 32; n <= 128; n *= 2) band = least(band, gain("dissection", "lapack", n))
    for (n = 16; n <= 128; n *= 2) notes = least(notes, peer("notes", n))
    split("stretch rigid traction spin", scene, " ")
    for (i = 1; i <= 4; i++) {
        worst = least(worst, kept(scene[i] " across", "worst_faster"))
        late = least(late, over(kept(scene[i] " within", "p99_ms"), \
            kept(scene[i] " across", "p99_ms")))
    }
    printf "\n  %-58s %9s %9s  %s\n", "times faster, or as it says", "goal", \
        "here", "met"
    line("band, factor and solve, than GSL, least of n = 32 to 128", 7, gsl)
    line("... than LAPACK", 1, lapack)
    line("step, best band, than the notes\047 with GSL, n = 64", 30, \
        of("step", "steps", "readable 64", "over_best"))
    line("step, dissection, than the band, n = 256", 4.5, \
        gain("dissection", "band", 256))
    line("step than PETSc with CHOLMOD, the notes\047 method, n = 8", 6, \
        peer("notes", 8))
    line("... least of n = 16 to 128", 10, notes)
    line("... with our method (code against code), n = 64", 0, peer("method", 64))
    line("... CHOLMOD in our own step, least of n = 32 to 256", 1.6, rival)
    line("... LAPACK\047s band in our own step, least of n = 32 to 128", 0, band)
    line("factors kept across steps, n = 128, stretch", 1.4, \
        kept("stretch across", "faster"))
    line("... in single precision", 1.9, kept("stretch across_single", "faster"))
    line("... rigid shake", 2, kept("rigid across", "faster"))
    line("... spin", 1, kept("spin across", "faster"))
    line("... 99th percentile of the steps, least of four scenes", 0.9, late)
    line("... worst step, least of four scenes", 0.9, worst)
    line("exponent of a step, n = 64 to 256, warm caches", -2.6, \
        growth("dissection", "to_"))
    line("... caches full of another\047s numbers", 0, growth("dissection", "cold_to_"))
    line("... with factors kept across steps, warm", -2.6, growth("kept", "to_"))
    line("bar, 1e6 unknowns: ns per unknown and iteration", -6, \
        sweep("both"))
    line("... than the same loop with GSL", 5, \
        over(sweep("gsl"), sweep("both")))
    line("largest n in time (1/30 s, 99 % of steps), stretched", 128, \
        of("realtime", "realtime", "dissection", "n"))
    line("largest n of which the whole swing is, 8 systems a step", 64, \
        of("realtime", "swing", "capped_most", "n"))
    line("make choose: predicted ms within 1.5 times, of 16 scenes", 16, \
        of("choose", "within", "all", "within"))
    printf "  one thread had %.0f %% of a processor: ", 100 * processor
    print (processor >= 0.95 ? "the machine was quiet." : \
        "the machine was NOT quiet, so the seconds are too long.")
    for (file in machine) if (file ~ /peer/) print "  " package ": " machine[file]
}
