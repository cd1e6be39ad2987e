# step_map.gp - a boundary moved by the jump dg, log law: where Newton
# converges, over dg and the number of elements of a bar of length 1.
# Predicted: dg < 1/n (push), dg < 2.2113/n (pull); with the linear lift n = 1.
# Reads   data  tables step_map, predicted
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,620 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
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
unset key
set multiplot layout 2,2 margins 0.115,0.98,0.115,0.94 spacing 0.1,0.14
do for [k = 1:4] {
    name = word("push pull push_lift pull_lift", k)
    limit = k == 1 || k == 3 ? PUSH_max : PULL_max
    set xlabel (k > 2 ? \
        "jump |Δ{/:Italic g}| of the boundary (m)" : "")
    set ylabel (k % 2 ? "elements n" : "")
    set label 1 word("push pull push pull", k).(k > 2 ? \
        ", from the linear lift" : ", from the last state") \
        at graph 1, graph 1.06 right
    set label 2 (k == 3 ? "log law" : "") at graph 0, graph 1.06 \
        left
    if (k < 3) {
        set arrow 1 from limit / 0.85, 0.85 to limit / 150, 150 nohead \
            lw 2 lc rgb "black" front
    } else {
        set arrow 1 from limit, 0.85 to limit, 150 nohead lw 2 \
            lc rgb "black" front
    }
    set label 3 (k == 1 ? "converged" : "") at 0.004, 5 tc rgb "#0072B2" front boxed
    set label 5 (k == 2 ? "line: predicted" : "") at 0.3, 60 front boxed
    set label 4 (k == 1 ? "inverted" : "") at 0.7, 30 tc rgb "#D55E00" front boxed
    plot data index "step_map" using "dg":(drawn("OK") ? column("n") : NaN) \
             with points pt 7 ps 0.55 lc rgb "#0072B2", \
         data index "step_map" using "dg":(drawn("INVERTED") ? \
             column("n") : NaN) with points pt 2 ps 0.6 lw 2 lc rgb "#D55E00"
}
unset multiplot
