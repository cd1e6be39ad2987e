# gains.gp - how many times fewer flops than linear triangles the others need, at
# an error of 0.003, in the pull of 0.001, where the meshes of both quadratic
# elements differ, in the swing of 0.01 and of 0.03, where all of them lose; the
# triangles are open, so that both marks are seen where they coincide.
# Expected: far to the right where there is a corner, or bending; a cross at the
# left where an element does not reach the error.
# Reads   data  table gains
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,460
set output out
array Name[8] = ["weight", "pull", "column", "shake", "swing", "swing", \
                 "explicit", "explicit"]
array Text[8] = ["weight, 0.003", "pull, 0.001", "column, 0.003", \
                 "shake, 0.003", "swing, 0.01", "swing, 0.03", \
                 "explicit, 0.01", "explicit, 0.03"]
array Error[8] = [0.003, 0.001, 0.003, 0.003, 0.01, 0.03, 0.01, 0.03]
of(k, what) = strcol("scene") eq Name[k] && column("error") == Error[k] \
              ? column(what) : NaN
# a cross where this element's finest mesh errs more, beside those of others
never(k, what, x) = strcol("scene") eq Name[k] && column("error") == Error[k] \
                    && strcol(what) eq "-" ? x : NaN
unset key
set tmargin 2.5
set logscale x
set xrange [0.025:60]
set xtics ("not reached" 0.033, "1/10" 0.1, "1/5" 0.2, "1/2" 0.5, "1" 1, "2" 2, \
           "5" 5, "10" 10, "20" 20, "40" 40)
set xlabel "times fewer flops than linear triangles, at the error named"
set yrange [8.5:0.5]
set ytics () scale 0
do for [k = 1:8] { set ytics add (Text[k] k) }
set arrow from 1, graph 0 to 1, graph 1 nohead ls 8 back
set label "linear, m = 1.5" at 0.3, graph 1.045 center tc rgb "#E69F00"
set label "quadratic" at 3, graph 1.045 center tc rgb "#0072B2"
set label "quadratic, m = 2" at 25, graph 1.045 center tc rgb "#009E73"
plot for [k = 1:8] data index "gains" using (of(k, "graded")):(k) \
         with points ls 5 ps 1.1, \
     for [k = 1:8] "" index "gains" using (of(k, "quadratic")):(k) \
         with points ls 1 ps 1, \
     for [k = 1:8] "" index "gains" using (of(k, "both")):(k) \
         with points ls 3 pt 8 ps 1.4 lw 2, \
     for [k = 1:8] "" index "gains" using (never(k, "graded", 0.03)):(k) \
         with points ls 5 pt 2 ps 1.1, \
     for [k = 1:8] "" index "gains" using (never(k, "quadratic", 0.033)):(k) \
         with points ls 1 pt 2 ps 1.1, \
     for [k = 1:8] "" index "gains" using (never(k, "both", 0.037)):(k) \
         with points ls 3 pt 2 ps 1.1
