# particles.gp - error of particles and of finite elements against counted flops
# and against milliseconds: the bar, the block, and the block in fewer and fewer
# steps.  Runs that fail have no cost and stand at the top.
# Reads   data  tables runs (body curve error flops ms reason), fewest (floor),
#               machine; from `make bench`
# Writes  out   SVG
if (!exists("data")) data = "build/data/work_precision/particles.tsv"
if (!exists("out"))  out  = "figures/work_precision/particles.svg"
load "figures/style.gp"
set terminal svg size 900,690
set output out
array Body[3] = ["bar", "block", "steps"]
array Title[3] = ["hanging bar: cells", "swinging block: cells", \
    "the block, 8 cells: steps"]
array Curve[9] = ["elements", "linear", "quadratic", "cubic", "FLIP", \
    "ten_linear", "ten_quadratic", "ten_cubic", "implicit"]
array Name[9] = ["elements", "linear", "quadratic", "cubic kernel", \
    "quadratic, FLIP", "linear, ten grids", "quadratic, ten grids", \
    "cubic, ten grids", "quadratic, implicit"]
array Color[9] = ["#000000", "#0072B2", "#D55E00", "#009E73", "#E69F00", \
    "#0072B2", "#D55E00", "#009E73", "#CC79A7"]
array Dash[9] = [1, 1, 1, 1, 1, 2, 2, 2, 1]
array Point[9] = [7, 9, 5, 13, 11, 8, 4, 12, 10]
of(b, k) = strcol("body") eq Body[int(b)] && \
    strcol("curve") eq Curve[int(k)] && strcol("reason") eq "OK" ? \
        column("error") : NaN
lost(b, k) = system(sprintf("awk -F'\t' '/^# / { t = $0 } \
    t == \"# runs\" && $1 == \"%s\" && $2 == \"%s\" && $9 != \"OK\" { n++ } \
    END { print n + 0 }' '%s'", Body[b], Curve[k], data)) + 0
set multiplot
set label 20 machine(data) at screen 0.01,0.012 left font ",10"
set logscale xy
set format xy "10^{%T}"
do for [row = 0:1] {
  do for [b = 1:3] {
    set lmargin at screen 0.08 + 0.312 * (b - 1)
    set rmargin at screen 0.08 + 0.312 * (b - 1) + 0.275
    set tmargin at screen 0.85 - 0.4 * row
    set bmargin at screen 0.85 - 0.4 * row - 0.31
    set label 1 (row ? "" : Title[b]) at graph 0.5, 1.07 center font ",14"
    set xlabel row ? "time to the answer (ms)" : "flops, counted"
    set ylabel b == 1 ? "relative error of u" : ""
    low = row ? 3e-3 : b == 1 ? 1e3 : 3e4
    high = row ? 2e3 : b == 1 ? 1e7 : 1e9
    set xrange [low:high]
    from = row ? 1e-2 : 1e3
    set xtics from, 10, high
    if (b == 1) { set yrange [5e-7:0.5] } else { set yrange [1e-3:0.7] }
    unset arrow 1
    if (row) { set arrow 1 from 1000.0 / 30, graph 0 to 1000.0 / 30, graph 0.88 nohead ls 8 }
    i = 0
    do for [k = 1:9] {
        unset label 30 + k
        if (lost(b, k) > 0) {
            set label 30 + k sprintf("× %d", lost(b, k)) \
                at graph 0.3 + 0.17 * i, 0.94 textcolor rgb Color[k] font ",12"
            i = i + 1
        }
    }
    set label 14 (i > 0 ? "failed" : "") at graph 0.05, 0.94 font ",12" \
        textcolor rgb "#555555"
    unset key
    cost = row ? "ms" : "flops"
    plot data index "fewest" using (low):(b == 1 ? 1e-9 : column("floor")):(high):(0) \
             with vectors nohead ls 8 dt 3 notitle, \
         for [k = 1:9] data index "runs" using (column(cost)):(of(b, k)) \
             with linespoints lw 1.5 pt Point[k] ps 0.6 lc rgb Color[k] \
             dt Dash[k] notitle, \
         data index "runs" using (column(cost)):(strcol("body") eq Body[b] && strcol("curve") eq "implicit_elements" ? column("error") : NaN) \
             with linespoints lw 1.5 pt 6 ps 0.6 lc rgb "black" notitle
    unset label 20
  }
}
# the key, in a plot of its own
unset label
unset arrow
set lmargin at screen 0.02
set rmargin at screen 0.99
set tmargin at screen 0.93
set bmargin at screen 0.92
unset border
unset tics
unset xlabel
unset ylabel
unset grid
set key at screen 0.52, 0.995 center top horizontal maxrows 3 samplen 2 \
    font ",11" reverse Left
plot for [k = 1:9] NaN with linespoints lw 1.5 pt Point[k] ps 0.7 \
         lc rgb Color[k] dt Dash[k] title Name[k], \
     NaN with linespoints lw 1.5 pt 6 ps 0.7 lc rgb "black" \
         title "elements, implicit", \
     NaN with lines ls 8 title "1/30 s", \
     NaN with lines ls 8 dt 3 title "known to"
unset multiplot
