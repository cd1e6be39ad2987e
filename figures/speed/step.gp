# bench_step_time.gp - what a whole time step costs, beside the limits of a
# core [eq:roofline], and what an accuracy costs.
# Expected: slope 4 in n for large n, where factoring is everything.
# Reads   data  tables notes, lapack (where there is one), blocked, best
#               (n median_ms p99_ms), roofline (n predicted_ms), realtime,
#               accuracy (n rms *_ms), machine; from `make bench`
# Writes  out   SVG
if (!exists("data")) data = "build/data/bench_step.tsv"
if (!exists("out"))  out  = "figures/bench_step_time.svg"
load "figures/style.gp"
set terminal svg size 860,500
set output out
array Table[4] = ["notes", "lapack", "blocked", "best"]
array Name[4] = ["readable, GSL banded", "LAPACK dpbtrf", \
                 "blocked band", "blocked band, lift, chord rule"]
array Style[4] = [2, 4, 3, 1]
# The entry of a column in row 0 of a table, 0 where there is none.
cell(table, name) = system(sprintf( \
    "awk -F'\t' -v t='# %s' -v c='%s' \
     '$0 == t { on = 1; next } /^# / { next } \
      on == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i; on = 2; next } \
      on == 2 { print $k; found = 1; exit } \
      END { if (!found) print 0 }' '%s'", \
    table, name, data)) + 0.0
within(k) = cell("realtime", Table[k])
ok(c) = column(c) > 0 ? column(c) : 1/0
there = ""
do for [k = 1:4] {
    if (cell(Table[k], "n") > 0) { there = there." ".k }
}

set multiplot layout 1,2 margins 0.075,0.985,0.155,0.735 spacing 0.10,0
set key above left vertical maxrows 6 reverse Left samplen 2 font ",12"
set label 1 machine(data) at screen 0.01,0.025 left font ",10"
set logscale xy
set format y "10^{%T}"
set xtics (8, 16, 32, 64, 128)
set xrange [7:150]
set yrange [1e-3:4e3]
set xlabel "squares a side n"
set ylabel "median time a step (ms)"
set label 2 "1/30 s" at 7.4,50 left font ",11"
plot for [k in there] data index Table[int(k)] \
         using "n":(ok("median_ms")) with linespoints ls Style[int(k)] \
         title sprintf("%s: n = %d in real time", Name[int(k)], \
                       within(int(k))), \
     data index "roofline" using "n":"predicted_ms" with lines ls 8 dt 4 \
         title "limits of the core, slope 4 in the end", \
     1000.0 / 30.0 with lines ls 8 notitle

unset label 1
unset label 2
set xtics auto
set format x "10^{%T}"
set xrange [1e-2:1e3]
set yrange [3e-5:5e-3]
set xlabel "median time a step (ms)"
set ylabel "difference from half the elements, rms (m)"
plot for [k in there] data index "accuracy" \
         using (ok(Table[int(k)]."_ms")):"rms" \
         with linespoints ls Style[int(k)] \
         notitle, \
     data index "accuracy" using (column("best_ms") * 0.85):"rms": \
         (sprintf("%d", column("n"))) with labels right font ",11" \
         title "at the points: n"
unset multiplot
