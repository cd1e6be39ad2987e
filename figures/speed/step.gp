# step.gp - what a whole time step costs, beside the limits of a core
# [eq:roofline], and what an accuracy costs.
# Expected: slope 4 in n for large n, where factoring is everything.
# Reads   data  tables steps (method n median_ms real_time), roofline
#               (n predicted_ms), accuracy (n rms *_ms), machine; from
#               `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,500
set output out
array Method[5] = ["readable", "lapack", "blocked", "best", "sparse"]
array Name[5] = ["readable, GSL banded", "dpbtrf of ".lapack(data), \
                 "blocked band", "blocked band, lift, chord rule", \
                 "nested dissection, lift, chord rule"]
array Style[5] = [2, 4, 6, 1, 3]
# The largest n of a method that is ready in time, 0 where there is none.
within(k) = system(sprintf("awk -F'\t' '$1 == \"%s\" && /\tyes\t/ \
    { n = $2 } END { print n + 0 }' '%s'", Method[k], data)) + 0
has(k) = system(sprintf("grep -c '^%s\t' '%s'", Method[k], data)) > 0
of(k) = strcol("method") eq Method[int(k)] ? column("n") : NaN
there = ""
do for [k = 1:5] { if (has(k)) { there = there." ".k } }

set multiplot layout 1,2 margins 0.075,0.985,0.155,0.705 spacing 0.10,0
set key above left vertical maxrows 7 reverse Left samplen 2 font ",12"
set label 1 machine(data) at screen 0.01,0.025 left font ",10"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128)
set xrange [7:150]
set yrange [1e-3:4e3]
set xlabel "squares per side n"
set ylabel "median time per step (ms)"
set label 2 "1/30 s" at 7.4,50 left font ",11"
plot for [k in there] data index "steps" \
         using (of(k)):"median_ms" with linespoints ls Style[int(k)] \
         title sprintf("%s: n = %d in real time", Name[int(k)], \
                       within(int(k))), \
     data index "roofline" using "n":"predicted_ms" with lines ls 8 dt 4 \
         title "limits of the core for a band, slope 4", \
     1000.0 / 30.0 with lines ls 8 notitle

unset label 1
unset label 2
set xtics auto
set format x "10^{%T}"
set xrange [1e-2:1e3]
set yrange [3e-5:5e-3]
set xlabel "median time per step (ms)"
set ylabel "difference from half the elements, rms (m)"
set arrow 3 from 1000.0 / 30, graph 0 to 1000.0 / 30, graph 1 nohead ls 8
plot for [k in there] data index "accuracy" \
         using (column(Method[int(k)]."_ms")):"rms" \
         with linespoints ls Style[int(k)] \
         notitle, \
     data index "accuracy" using (0.75 * (column("best_ms") < column("sparse_ms") ? \
             column("best_ms") : column("sparse_ms"))):"rms": \
         (sprintf("%d", column("n"))) with labels right font ",11" \
         title "at the points: n"
unset multiplot
