# ladder.gp - the parts of the estimate on every rung, and their sum, with the
# verdict: the lesson's own numbers.
# Reads   data  table ladder (rung model estimate verdict and the parts)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 700,400
set output out
array Part[6] = ["geometry", "law", "dimension", "inertia", "mesh_part", "stress"]
# parts that are nowhere to be seen are left out
seen = ""
do for [i = 1:6] {
    stats reference index "ladder" using (column(Part[i])) nooutput
    if (STATS_max >= 0.02) { seen = seen . " " . i }
}
stats reference index "ladder" using "rung" nooutput
set xrange [0.5:STATS_max + 0.8]
set xlabel "rung"
set ylabel "estimate, and its parts"
set yrange [0:1.75]
set xtics 1
set style fill solid noborder
set boxwidth 0.13
# what the reference says lies behind
plot reference index "ladder" using "rung":(reference eq data ? NaN : column("estimate")) with lines lw 7 \
         lc rgb "#DDDDDD" notitle, \
     for [k in seen] data index "ladder" \
         using (column("rung") + 0.13 * (k - 3.5)):(column(Part[int(k)])) \
         with boxes ls (k == 5 ? 6 : k == 6 ? 5 : int(k)) \
         title k == 5 ? "mesh" : Part[int(k)], \
     data index "ladder" using "rung":"estimate" with linespoints lw 2 pt 7 \
         lc rgb "black" title "estimate", \
     data index "ladder" using (column("rung")):(column("estimate") + 0.06): \
         (strcol("verdict")) with labels left offset 0.5, 0.5 notitle
