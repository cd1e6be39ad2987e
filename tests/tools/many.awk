# many.awk - do the goals of figures/many/ hold?  Reads its tables, prints a line
# for each goal, and ends with status 1 when one is missed.  Where there are
# tables of seconds as well, it compares these; they are not held to a goal.
#
#     awk -F '\t' -f tests/tools/many.awk figures/many/many.tsv [SECONDS]

/^#/ { table = $1; next }
NF == 0 { next }
$1 == "n" { split("", at); for (c = 1; c <= NF; c++) at[$c] = c; next }
function most(name, x) { if (x > largest[name]) largest[name] = x }
table == "# runs" {
    if ($at["agrees"] == "yes") agree++
    if ($at["agrees"] == "no") differ++
    if ($3 != "geometric") next
    if ($4 == 30) most("systems", $at["per_step"])
    most("most", $at["most"])
    if ($1 >= 32) most("iterations", $at["iterations"])
    if ($2 == 1 && $4 == 6) {
        growth[$1] = $at["iterations"]
        work[$1] = $at["flops"] * ($1 + 1) ^ 2 # twice that, of all unknowns
    }
    if ($2 == 1 && $1 == 512) memory = $at["bytes"] / 1e3
}
table == "# messages" && $at["predicted"] != "-" && $1 >= 64 {
    off($at["messages"], $at["predicted"])
    off($at["kilobyte"], $at["predicted_kilobyte"])
}
function off(is, predicted) {
    most("off", is > predicted ? is / predicted - 1 : 1 - is / predicted)
}
table == "# seconds" && $3 == "geometric" && $2 == 1 && $5 != "-" {
    meet("dissection", $1, $4, $5); meet("a band", $1, $4, $6)
}
# where the straight line between two runs crosses, in logarithms
function meet(k, n, ours, theirs,    d) {
    d = log(ours / theirs)
    if (k in before && d < 0 && before[k] >= 0 && n > last[k])
        from[k] = exp(log(last[k]) + log(n / last[k]) \
            * before[k] / (before[k] - d))
    if (d > 0) delete from[k]
    before[k] = d; last[k] = n
}
function say(k) {
    if (k in from) printf("Faster than step.c with %s from n = %.0f on.\n", k,
                          from[k])
    else if (k in before) print "Never faster than step.c with " k " here."
}
table == "# round_seconds" { rounds[$1, $2] = rounds[$1, $2] " " $4 }
# Of three, that which is between the two others; 0: there are fewer.
function median(n, processes,    x, i, j, k) {
    printf("  n = %d, geometric on %d: ", n, processes)
    if (split(rounds[n, processes], x, " ") < 3) {
        print "none, the machine was busy in one of the rounds"
        return 0
    }
    for (i = 1; i <= 3; i++) {
        j = i % 3 + 1; k = j % 3 + 1
        if ((x[i] - x[j]) * (x[i] - x[k]) <= 0) break
    }
    printf("%.3g (of %.3g, %.3g, %.3g)\n", x[i], x[1], x[2], x[3])
    return x[i]
}
function compare(    n, two, of_seconds, of_work, slower) {
    say("dissection"); say("a band")
    print "Seconds per step, the median of three interleaved rounds:"
    for (n = 64; n <= 512; n *= 2) one[n] = median(n, 1)
    two = median(256, 2)
    if (one[256] > 0 && two > 0)
        printf("Two processes at n = 256: %.3g times one (goal: 1.7)\n",
               one[256] / two)
    for (n = 64; n <= 128; n *= 2) {
        of_seconds = exponent(one, n, 512)
        of_work = exponent(work, n, 512)
        if (!of_seconds) continue
        printf("Exponent from n = %d to 512: seconds %.2f, operations %.2f\n",
               n, of_seconds, of_work)
        if (of_seconds > of_work + 0.1) slower = 1
    }
    if (slower)
        print "The seconds grow faster: the small n fits into the caches and " \
              "the large one does not."
}
# The e of cost ~ n^e; 0 where one of the two is missing.
function exponent(cost, small, large) {
    if (!(cost[small] > 0 && cost[large] > 0)) return 0
    return log(cost[large] / cost[small]) / log(large / small)
}
# What was not measured is missed as well.
function goal(is, allowed, text) {
    holds = (is > 0 && is <= allowed)
    printf("  %s %s: %.3g (allowed %g)\n", holds ? "holds  " : "MISSED ", text,
           is, allowed)
    if (!holds) missed = 1
}
END {
    print "  " (agree && !differ ? "holds  " : "MISSED ") " " agree + 0 \
        " runs agree with step.c to 1e-12 m"
    if (!agree || differ) missed = 1
    goal(largest["systems"], 3.3, "systems per step of 30, at most")
    goal(largest["most"], 6, "systems in one step, at most")
    goal(largest["iterations"], 4.5, "iterations per system, at most")
    goal(growth[64] > 0 ? growth[512] / growth[64] : 0, 1.15, \
         "iterations at n = 512 over those at n = 64")
    goal(exponent(work, 128, 512), 2.1, "exponent of the operations, n = 128 to 512")
    goal(exponent(work, 64, 512), 2.3, "exponent of the operations, n = 64 to 512")
    goal(largest["off"], 0.25, "messages and bytes, off from paper by")
    goal(memory, 2.2, "kilobytes per unknown at n = 512")
    if (table == "# round_seconds") compare()
    exit missed
}
