# bench.awk - the closing table of `make bench`: what was wanted, what was
# measured here, and whether it was met.
#
#     awk -v processor=SHARE -f bench.awk build/data/speed/*.tsv
#
# Reads the tables that the studies of figures/speed have printed.  processor:
# the seconds of the processor that they had, by the seconds that went by; one
# thread on a quiet machine has nearly all of them.  A number that is not there
# (no LAPACK, no CHOLMOD) is `-`, and its goal neither met nor missed.
BEGIN { FS = "\t" }
FNR == 1 { n = split(FILENAME, part, "/"); study = part[n]
           sub(/[.]tsv$/, "", study); table = ""; head = 0 }
/^# / && table == "" { table = substr($0, 3); head = 0; next }
/^#/ { next }
NF == 0 { table = ""; next }
!head { head = 1; for (i in column) delete column[i]
        for (i = 1; i <= NF; i++) column[i] = $i
        columns = NF; next }
{ # value[study, table, key, column], the key being the words and n of a row
    key = ""
    for (i = 1; i <= columns; i++)
        if (is_key(column[i])) key = key (key == "" ? "" : " ") $i
    for (i = 1; i <= columns; i++) value[study, table, key, column[i]] = $i
}
function is_key(name) {
    return name == "n" && table != "realtime" && table != "swing" ||
        name == "solver" || name == "method" || name == "line" ||
        name == "unknowns" || table == "swing" && name == "systems"
}
function of(study, table, key, name,    cell) {
    cell = (study, table, key, name) in value ? value[study, table, key, name] : "-"
    return cell ~ /^-?[0-9.]/ ? cell + 0 : "-"
}
function least(a, b) { return a == "-" ? b : b == "-" ? a : a < b ? a : b }
function most(a, b) { return a == "-" ? b : b == "-" ? a : a > b ? a : b }
function over(a, b) { return a == "-" || b == "-" || b == 0 ? "-" : a / b }
# goal > 0: at least; < 0: at most; 0: none
function line(what, goal, got,    met, wanted, here, word) {
    met = got == "-" || goal == 0 ? "" : goal > 0 ? got >= goal : got <= -goal
    wanted = goal == 0 ? "-" : (goal > 0 ? ">= " goal : "<= " (-goal))
    here = got == "-" ? "-" : sprintf("%.4g", got)
    word = met == "" ? "-" : met ? "yes" : "NO"
    printf "  %-58s %9s %9s  %s\n", what, wanted, here, word
}
function gain(other, k, n) { # times that `k` takes longer than `other`
    return over(of("solvers", "solvers", k " " n, "step_ms"),
                of("solvers", "solvers", other " " n, "step_ms"))
}
END {
    gsl = lapack = rival = systems = "-"
    for (n = 32; n <= 128; n *= 2) {
        gsl = least(gsl, of("band", "band", "gsl_banded " n, "over_ours"))
        lapack = least(lapack, of("band", "band", "lapack_dpbtrf " n, "over_ours"))
    }
    for (n = 32; n <= 256; n *= 2) rival = least(rival, gain("dissection", "cholmod", n))
    for (n = 8; n <= 128; n += 8)
        systems = most(systems, of("step", "steps", "sparse " n, "systems"))
    printf "\n  %-58s %9s %9s  %s\n", "what", "goal", "here", "met"
    line("band, factor and solve: times faster than GSL, 32 to 128", 7, gsl)
    line("... than LAPACK", 1, lapack)
    line("step, band: times faster than the notes' with GSL, n = 32", 20, \
        of("step", "steps", "readable 32", "over_best"))
    line("... n = 64", 30, of("step", "steps", "readable 64", "over_best"))
    line("step: linear systems, most of all n", -2.7, systems)
    line("step, dissection: times faster than the band, n = 64", 1.2, \
        gain("dissection", "band", 64))
    line("... n = 256", 4.5, gain("dissection", "band", 256))
    line("... than with CHOLMOD, 32 to 256", 1.6, rival)
    line("... with factors kept across steps, n = 128", 1.4, \
        gain("kept", "dissection", 128))
    line("... kept, single precision, n = 128", 1.9, \
        gain("kept_single", "single", 128))
    line("step: exponent of seconds, n = 64 to 128", 0, \
        of("solvers", "growth", "dissection", "to_128"))
    line("... n = 128 to 256", 0, of("solvers", "growth", "dissection", "to_256"))
    line("element with its tangent, n = 32 (ns)", -35, \
        of("assembly", "assembly", "32", "both"))
    line("bar, a million unknowns: ns per unknown and iteration", -6, \
        of("newton_1d", "bar", "1000000 fused_both", "ns_per_unknown"))
    line("make choose: predicted ms within a factor 1.5, of 16 scenes", 16, \
        of("choose", "within", "all", "within"))
    line("in time (1/30 s, 99 of 100) while stretched: largest n", 128, \
        of("realtime", "realtime", "dissection", "n"))
    line("in time, every step of the swing, 8 systems: largest n", 64, \
        of("realtime", "swing", "capped_most", "n"))
    printf "  one thread had %.0f %% of a processor: ", 100 * processor
    print (processor >= 0.95 ? "the machine was quiet." : \
        "the machine was NOT quiet, so the seconds are too long.")
}
