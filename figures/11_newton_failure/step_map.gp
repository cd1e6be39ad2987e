# step_map.gp - a boundary moved by the jump dg, log law: where Newton
# converges, over dg and the number of elements of a bar of length 1.
# Predicted: dg < 1/n (push), dg < 2.2113/n (pull); with the linear lift n = 1.
# Reads   data  tables step_map, predicted
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,620
set output out
stats data index "predicted" using "push" name "PUSH" nooutput
# every second jump; the rows go through all n of one jump
sizes = system("awk -F'\t' '$1 == \"# step_map\" { on = 1 } NF == 0 { on = 0 } \
    on && $2 ~ /^[0-9]/ && !seen[$2]++ { n++ } END { print n }' '".data."'") + 0
drawn(reason) = strcol(name) eq reason && int(column(0) / sizes) % 2 == 0
stats data index "predicted" using "pull" name "PULL" nooutput
set logscale xy
set xrange [0.0028:11]
set yrange [0.85:150]
set format x "10^{%T}"
set key above left horizontal maxrows 1 samplen 1.5
set multiplot layout 2,2 margins 0.085,0.98,0.09,0.93 spacing 0.07,0.12
do for [k = 1:4] {
    name = word("push pull push_lift pull_lift", k)
    limit = k == 1 || k == 3 ? PUSH_max : PULL_max
    set xlabel (k > 2 ? \
        "jump |Δ{/:Italic g}| of the boundary (length of the bar: 1)" : "")
    set ylabel (k % 2 ? "elements n" : "")
    set label 1 word("push pull push pull", k).(k > 2 ? \
        ", from the linear lift" : ", from the last state") \
        at graph 1, graph 1.06 right font ",13"
    set label 2 (k == 2 ? "line: predicted" : \
        k == 3 ? "log law, one end moved" : "") at graph 0, graph 1.06 \
        left font ",13"
    if (k < 3) {
        set arrow 1 from limit / 0.85, 0.85 to limit / 150, 150 nohead \
            lw 2 lc rgb "black" front
    } else {
        set arrow 1 from limit, 0.85 to limit, 150 nohead lw 2 \
            lc rgb "black" front
    }
    if (k == 1) {
        set key at graph -0.04, graph 1.12 left top width -1
    } else { unset key }
    plot data index "step_map" using "dg":(drawn("OK") ? column("n") : NaN) \
             with points pt 7 ps 0.55 lc rgb "#0072B2" \
             title "converged", \
         data index "step_map" using "dg":(drawn("INVERTED") ? \
             column("n") : NaN) with points pt 2 ps 0.6 lw 2 lc rgb "#D55E00" \
             title "inverted"
}
unset multiplot
