# assembly.gp - residual and tangent of one element, in ns: with
# dP/dF applied to six directions, and in closed form.
# Reads   data  table assembly (n readable both residual projected clear, ns),
#               machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,400
set output out
array Column[5] = ["readable", "projected", "both", "residual", "clear"]
array Name[5] = ["readable", "closed form, clamped", \
                 "closed form", "residual alone", "zeros into the band"]
array Colour[5] = ["#D55E00", "#CC79A7", "#0072B2", "#009E73", "#999999"]
unset key
set label 1 machine(data) at screen 0.01,0.03 left font ",10"
set bmargin 4.5
set style fill solid 0.9 noborder
set boxwidth 0.15
set grid noxtics
set xrange [-0.5:2.5]
do for [k = 1:5] { # the name of a bar of the first group, on the bar
    stats data index "assembly" using (column(Column[k])) every ::0::0 nooutput
    set label k + 1 Name[k] at 0.17 * (k - 3), STATS_max + 12 rotate by 90 \
        tc rgb Colour[k]
}
stats data index "assembly" using "readable" nooutput
set yrange [0:1.45 * STATS_max]
set xtics ("16" 0, "32" 1, "64" 2)
set xlabel "squares per side n"
set ylabel "time per element (ns)"
plot for [k = 1:5] data index "assembly" \
         using ($0 + 0.17 * (k - 3)):(column(Column[k])) with boxes \
         lc rgb Colour[k]
