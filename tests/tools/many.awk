# many.awk - do the goals of figures/many/ hold?  Reads its tables, prints a line
# for each goal, and ends with status 1 when one is missed.
#
#     awk -F '\t' -f tests/tools/many.awk figures/many/many.tsv

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
    if ($2 == 1 && $4 == 6) growth[$1] = $at["iterations"]
    if ($2 == 1 && $1 == 512) memory = $at["bytes"] / 1e3
}
table == "# messages" && $at["predicted"] != "-" && $1 >= 64 {
    off($at["messages"], $at["predicted"])
    off($at["kilobyte"], $at["predicted_kilobyte"])
}
function off(is, predicted) {
    most("off", is > predicted ? is / predicted - 1 : 1 - is / predicted)
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
    goal(largest["off"], 0.25, "messages and bytes, off from paper by")
    goal(memory, 2.2, "kilobytes per unknown at n = 512")
    exit missed
}
