# chart.gp - the speed-accuracy chart of the bar: what an
# error costs with four programs, and what they need per unknown and step.
# Expected: error ~ n^-2 and cost ~ n, slope -2.
# Reads   data  tables chart_readable, chart_gsl, chart_fused, chart_both (n
#               iterations error seconds ns_per_unknown), machine
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,430 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
array Table[4] = ["chart_readable", "chart_gsl", "chart_fused", "chart_both"]
array Name[4] = ["readable", "GSL tridiagonal", "fused sweep", \
                 "fused, both ends"]
array Style[4] = [2, 5, 3, 1]
# The entry of a column in row r = 0, 1, ... of a table.
cell(table, name, r) = system(sprintf( \
    "awk -F'\t' -v t='# %s' -v c='%s' -v r=%d \
     '$0 == t { on = 1; next } /^# / { next } \
      on == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i; on = 2; next } \
      on == 2 && r-- == 0 { print $k; exit }' '%s'", \
    table, name, r, data)) + 0.0

# Slope from the first to the last valid point with n >= 256.
last(t) = int(system(sprintf("awk -v t='# %s' '$0 == t { on = 1 } \
    on && /^[0-9]/ { k++ } on && /^$/ { print k - 1; exit }' '%s'", t, data)))
slope(t) = log(cell(t, "error", last(t)) / cell(t, "error", 2)) / \
           log(cell(t, "seconds", last(t)) / cell(t, "seconds", 2))

set multiplot layout 1,2 margins 0.13,0.785,0.235,0.965 spacing 0.14,0
unset key
set label 9 machine(data) at screen 0.01,0.035 left
set logscale xy
set format xy "10^{%T}"
set xrange [3e-7:0.3]
set xtics 1e-6, 100
set yrange [1e-14:1e-3]
set ytics 1e-14, 100
unset mxtics; unset mytics
set xlabel "time of the whole solve (s)"
set ylabel "relative error of u(1)"
set arrow 1 from 1/30., 1e-14 to 1/30., 1e-3 nohead lw 2 lc rgb "#999999"
set label 1 "1/30 s" at 0.025, 3e-4 right boxed
set label 2 "slopes near -2\n(dashed)" at 4e-7, 5e-13 boxed
set label 3 "readable" at 1.3e-4, 8e-6 tc ls 2 boxed
set label 4 "both ends" at 1e-4, 5e-10 right tc ls 1 boxed
set label 5 "(colours:\nsee right)" at 1e-4, 1e-10 right font ",14" boxed
plot for [s = 1:4] data index Table[s] using "seconds":"error" \
         with linespoints ls Style[s], \
     4e-17 * x**-2 with lines ls 8

unset label
unset arrow
set format y "%g"
set ytics (2, 5, 10, 20, 50, 100, 200)
set xrange [8:4e5]
set xtics 1e2, 100
set yrange [3:200]
set xlabel "elements n"
set ylabel "time per unknown and step (ns)"
do for [s = 1:4] {
    color = Style[s]
    ns = cell(Table[s], "ns_per_unknown", last(Table[s]))
    set label s sprintf("%s:\n%.1f ns", Name[s], ns) at 5e5, 1.05 * ns tc ls color
}
plot for [s = 1:4] data index Table[s] using "n":"ns_per_unknown" \
         with linespoints ls Style[s]
unset multiplot
