# step.gp - what a whole time step costs, beside the limits of a core
# [eq:roofline], and what an accuracy costs.
# Expected: slope 4 in n for large n, where factoring is everything.
# Reads   data  tables steps (method n median_ms real_time), roofline
#               (n predicted_ms), accuracy (n rms *_ms), machine, and peer
#               (method n step_ms) of figures/many/peer.c; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,430
set output out
array Method[5] = ["readable", "lapack", "blocked", "best", "sparse"]
array Name[5] = ["readable: GSL, band", "lapack: ".lapack(data).", band", \
                 "blocked: our band", "best: with lift and chord rule", \
                 "sparse: the same by dissection"]
array Style[5] = [2, 4, 6, 1, 3]
# The largest n of a method that is ready in time, 0 where there is none.
within(k) = system(sprintf("awk -F'\t' '$1 == \"%s\" && /\tyes\t/ \
    { n = $2 } END { print n + 0 }' '%s'", Method[k], data)) + 0
has(k) = system(sprintf("grep -c '^%s\t' '%s'", Method[k], data)) > 0
of(k) = strcol("method") eq Method[int(k)] ? column("n") : NaN
there = ""
do for [k = 1:5] { if (has(k)) { there = there." ".k } }

peer = system(sprintf("grep -c '^# peer' '%s'", data)) > 0
rows = peer ? "notes method" : ""

# where the name of a method stands, right of its last point
array Height[5] = [3200, 1150, 190, 88, 11]
set multiplot
unset key
set tmargin at screen 0.95
set bmargin at screen 0.17
set lmargin at screen 0.075
set rmargin at screen 0.40
set label 9 machine(data) at screen 0.01,0.025 left font ",10"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128)
set xrange [7:140]
set yrange [1e-3:8e3]
set xlabel "squares per side n"
set ylabel "median time per step (ms)"
set label 10 "1/30 s" at 7.4,55 left font ",11"
set label 11 "dash-dotted: limits of the core, band" at 150, 24 font ",11"
set label 12 "(in real time up to n)" at 150, 7500 font ",11"
do for [k in there] {
    i = int(k)
    color = Style[i]
    set label i sprintf("%s (%d)", Name[i], within(i)) at 150, Height[i] \
        font ",11" tc ls color
}
by(word) = strcol("method") eq word ? column("n") : NaN
if (peer) {
    set label 13 "PETSc, notes (triangles)" at 150, 470 font ",11" tc ls 5
    set label 14 "PETSc, method (diamonds)" at 150, 46 font ",11" tc ls 5
}
plot for [k in there] data index "steps" \
         using (of(k)):"median_ms" with linespoints ls Style[int(k)], \
     for [word in rows] data index "peer" using (by(word)):"step_ms" \
         with points ls 5 pt (word eq "notes" ? 11 : 12) ps 1, \
     data index "roofline" using "n":"predicted_ms" with lines ls 8 dt 4, \
     1000.0 / 30.0 with lines ls 8
unset label
set lmargin at screen 0.715
set rmargin at screen 0.985
set xtics auto
set format x "10^{%T}"
set xrange [1e-2:1e3]
set yrange [5e-5:5e-3]
set xlabel "median time per step (ms)"
set ylabel "difference from half the elements, rms (m)"
set arrow 3 from 1000.0 / 30, graph 0 to 1000.0 / 30, graph 1 nohead ls 8
plot for [k in there] data index "accuracy" \
         using (column(Method[int(k)]."_ms")):"rms" \
         with linespoints ls Style[int(k)], \
     data index "accuracy" using (0.75 * (column("best_ms") < column("sparse_ms") ? \
             column("best_ms") : column("sparse_ms"))):"rms": \
         (sprintf(column("n") == 8 ? "n = %d" : "%d", column("n"))) \
         with labels right font ",11"
unset multiplot
