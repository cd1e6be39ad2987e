# assembly.gp - residual and tangent of one element, in ns: with
# dP/dF applied to six directions, and in closed form.
# Reads   data  table assembly (n readable both residual projected clear, ns),
#               machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,540
set output out
array Column[5] = ["readable", "projected", "both", "residual", "clear"]
array Name[5] = ["readable", "closed form, clamped", \
                 "closed form", "residual alone", "zeros"]
array Colour[5] = ["#D55E00", "#CC79A7", "#0072B2", "#009E73", "#555555"]
name(k, group) = k == 5 && group == 0 ? \
    "zeros into the band (part of the upper three)" : Name[k]
place(group, k) = 6.0 * group + k
unset key
set label 1 machine(data) at screen 0.01,0.022 left textcolor rgb "#555555"
set lmargin 6
set rmargin 3
set tmargin 1
set bmargin 5
set style fill solid 0.9 noborder
set style textbox opaque noborder margins 0.3,0.3
set grid noytics
stats data index "assembly" using "readable" nooutput
set xrange [0:1.3 * STATS_max]
set yrange [17.8:0.2]
set ytics ("16" 3, "32" 9, "64" 15) scale 0
set ylabel "squares per side n"
set xlabel "time per element (ns)"
plot for [k = 1:5] data index "assembly" \
         using (0):(place($0, k)):(0):(column(Column[k])):(place($0, k) - 0.42): \
         (place($0, k) + 0.42) with boxxyerror lc rgb Colour[k], \
     for [k = 1:5] data index "assembly" \
         using (column(Column[k]) + 0.01 * STATS_max):(place($0, k)):(name(k, $0)) \
         with labels left boxed tc rgb Colour[k]
