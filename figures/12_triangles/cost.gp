# cost.gp - what the next mesh still changes, against the flops of the static
# solve, and how many of them 33 ms have room for.
# The rates are those of the chapter on speed, for its core: GSL's band, and the
# tiles of this library.
# Reads   data  tables cost, fits
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,440
set output out
stats data index "cost" using (column("n") == 32 ? column("banded") : 1/0) \
    nooutput name "X"
stats data index "cost" using (column("n") == 32 ? column("change") : 1/0) \
    nooutput name "Y"
set logscale xy
set xrange [5e4:1e10]
set yrange [8e-4:0.2]
set format x "10^{%T}"
set format y "%g"
set xlabel "flops of the whole solve, six Newton steps"
set ylabel "what half the elements still change, relative"
set key above left maxrows 3 samplen 2
rate(k) = system(sprintf("awk -F'\t' '$0 == \"# fits\" { on = 1; next } \
    on && $1 ~ /^[0-9]/ && ++k == %d { print $1 }' '%s'", k, data)) + 0.0
do for [k = 1:2] {
    room = rate(k) / 30
    set arrow k from room, graph 0 to room, graph 1 nohead ls 8
    set label k sprintf("33 ms at\n%g·10^9/s", rate(k) / 1e9) at room*1.15, 0.15
}
plot data index "cost" using "banded":"change" with linespoints ls 1 \
         title "band, as in this lesson", \
     "" index "cost" using "dissected":"change" with linespoints ls 3 \
         title "nested dissection (lesson 21)", \
     "" index "cost" using "banded":"change":(sprintf("n = %d", column("n"))) \
         with labels left offset 0.7,0.6 notitle, \
     [2e7:1e10] 0.85 * Y_max * (x / X_max)**(-1.42/4) with lines ls 8 dt 3 \
         title "n^{-1.42} and n^4 expected"
