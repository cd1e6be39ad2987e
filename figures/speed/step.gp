# step.gp - what a whole time step costs, beside the limits of a core
# [eq:roofline], and what an accuracy costs.
# Expected: slope 4 in n for large n, where factoring is everything.
# Reads   data  tables steps (method n samples median_ms real_time), roofline
#               (n predicted_ms), accuracy (n rms *_ms), machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,900
set output out
set style line 6 pt 15 ps 0.7  # full, as a hollow mark means few steps
array Method[5] = ["readable", "lapack", "blocked", "best", "sparse"]
array Name[5] = ["readable", "lapack: ".lapack(data), "blocked", "best", "sparse"]
array Style[5] = [2, 4, 6, 1, 3]
# The largest n of a method that is ready in time, 0 where there is none.
within(k) = system(sprintf("awk -F'\t' '$1 == \"%s\" && /\tyes\t/ \
    { n = $2 } END { print n + 0 }' '%s'", Method[k], data)) + 0
has(k) = system(sprintf("grep -c '^%s\t' '%s'", Method[k], data)) > 0
of(k) = strcol("method") eq Method[int(k)] ? column("n") : NaN
there = ""
do for [k = 1:5] { if (has(k)) { there = there." ".k } }

# where the name of a method stands, right of its last point
array Height[5] = [4500, 720, 205, 51, 12]
set multiplot
unset key
set lmargin at screen 0.12
set rmargin at screen 0.745
set tmargin at screen 0.98
set bmargin at screen 0.56
set label 9 machine(data) at screen 0.01,0.010 left textcolor rgb "#555555"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128)
set xrange [7:140]
set yrange [1e-3:8e3]
set xlabel "squares per side n"
set ylabel "median time per step (ms)"
set label 10 "1/30 s" at 8.6,55 left
set label 11 "bound for a band" at 15, 0.006
do for [k in there] {
    i = int(k)
    set label i sprintf("%s (%d)", Name[i], within(i)) at 150, Height[i] tc ls Style[i]
}
plot for [k in there] data index "steps" \
         using (of(k)):"median_ms" with linespoints ls Style[int(k)], \
     for [k in there] data index "steps" \
         using (column("samples") < 90 ? of(k) : NaN):"median_ms" \
         with points pt 7 ps 0.3 lc rgb "white", \
     data index "roofline" using "n":"predicted_ms" with lines ls 8 dt 4, \
     1000.0 / 30.0 with lines ls 8
unset label
set tmargin at screen 0.45
set bmargin at screen 0.09
set xtics auto
set format x "10^{%T}"
set xrange [2e-3:1e3]
set yrange [2.2e-5:5e-3]
set xlabel "median time per step (ms)"
set ylabel "change of u when h is halved, rms (m)"
set label 10 "1/30 s" at 36, 3.8e-3
# what the step leaves, figures/work_precision/flagship.c
set label 12 "error of time" at 900, 2.6e-3 right tc ls 8
set label 14 "error of time after a soft start (n = 8)" at 2.6e-3, 3.1e-5 tc ls 8
# a name below the last point, on one of two rows, beside the line of 1/30 s
array Beside[5] = [1, 1.7, 0.55, 1, 0.65]
array Below[5] = [6.6e-5, 4.8e-5, 6.6e-5, 4.8e-5, 6.6e-5]
last(k) = column("n") == 64 ? column(Method[int(k)]."_ms") : NaN
set arrow 3 from 1000.0 / 30, graph 0 to 1000.0 / 30, graph 1 nohead ls 8
plot 2.0e-3 with lines ls 8, 4.0e-5 with lines ls 8, \
     for [k in there] data index "accuracy" \
         using (column(Method[int(k)]."_ms")):"rms" \
         with linespoints ls Style[int(k)], \
     for [k in there] data index "accuracy" using (Beside[int(k)] * last(k)): \
         (Below[int(k)]):(Method[int(k)]) with labels center tc ls Style[int(k)], \
     data index "accuracy" using (0.75 * (column("best_ms") < column("sparse_ms") ? \
             column("best_ms") : column("sparse_ms"))):"rms": \
         (sprintf(column("n") == 8 ? "n = %d" : "%d", column("n"))) \
         with labels right
unset multiplot
