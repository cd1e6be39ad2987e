# ladder.gp - the parts of the estimate on every rung, and their sum, with the
# verdict: the lesson's own numbers.
# Reads   data  table ladder (rung model estimate verdict and the parts)
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 700,400
set output out
array Part[6] = ["geometry", "law", "dimension", "inertia", "mesh_part", "stress"]
# parts that are nowhere to be seen have no name
array Name[6]
do for [i = 1:6] {
    stats reference index "ladder" using (column(Part[i])) nooutput
    Name[i] = STATS_max < 0.02 ? "" : i == 5 ? "mesh" : Part[i]
}
set xlabel "rung"
set ylabel "estimate, and its parts"
set yrange [0:1.75]
set xtics 1
set style fill solid noborder
set boxwidth 0.13
plot reference index "ladder" using "rung":"estimate" with lines lw 7 \
         lc rgb "#DDDDDD" notitle, \
     for [i = 1:6] data index "ladder" \
         using (column("rung") + 0.13 * (i - 3.5)):(column(Part[i])) \
         with boxes ls (i == 5 ? 6 : i == 6 ? 5 : i) title Name[i], \
     data index "ladder" using "rung":"estimate" with linespoints lw 2 pt 7 \
         lc rgb "black" title "estimate", \
     data index "ladder" using (column("rung")):(column("estimate") + 0.06): \
         (strcol("verdict")) with labels left offset 0.5, 0.5 notitle
