# cost.gp - what the next mesh still changes, against the flops of the static
# solve, and how many of them 33 ms have room for.
# The rates are those of the chapter on speed, for its core: GSL's band, and the
# tiles of this library.
# Reads   data  tables cost, fits
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,440 enhanced font "Helvetica,14" \
    background rgb "white"
unset key
set output out
set style textbox opaque noborder margins 0.3,0.3
stats data index "cost" using (column("n") == 32 ? column("banded") : 1/0) \
    nooutput name "X"
stats data index "cost" using (column("n") == 32 ? column("change") : 1/0) \
    nooutput name "Y"
set logscale xy
set xrange [3e4:1e10]
set yrange [8e-4:0.2]
set format x "10^{%T}"
set format y "%g"
set xlabel "flops of the whole solve, six Newton steps"
set ylabel "change of the sag, relative, when h is halved"
set label 3 "band, as in\nthis lesson" at 2.2e6, 5.5e-2 tc ls 1 boxed
set label 4 "nested dissection\n(lesson 21)" at 1.15e6, 4.0e-3 tc ls 3 boxed
set label 5 "dotted: slope\nof a band" at 1.5e7, 2.8e-2 boxed
rate(k) = system(sprintf("awk -F'\t' '$0 == \"# fits\" { on = 1; next } \
    on && $1 ~ /^[0-9]/ && ++k == %d { print $1 }' '%s'", k, data)) + 0.0
do for [k = 1:2] {
    room = rate(k) / 30
    set arrow k from room, graph 0 to room, graph 1 nohead ls 8
    set label k sprintf("33 ms at\n%g·10^9/s", rate(k) / 1e9) at room*1.15, 0.155 boxed
}
# No label on a curve or a limit: the coarse ones stand below, the fine above.
label(from, to) = column("n") < from || column("n") > to ? "" : \
    sprintf("n = %d", column("n"))
plot data index "cost" using "banded":"change" with linespoints ls 1, \
     "" index "cost" using "dissected":"change" with linespoints ls 3, \
     "" index "cost" using "banded":"change":(label(4, 16)) \
         with labels right tc ls 1 offset -1,-0.9, \
     "" index "cost" using "banded":"change":(label(32, 64)) \
         with labels center tc ls 1 offset -1.5,1.8, \
     [2e7:1e10] 2.5 * Y_max * (x / X_max)**(-1.42/4) with lines ls 8 dt 3
