# fronts.gp - error against milliseconds of every setting (grey), the front, whose
# corners say law, method, n x steps, the floor of the reference, and the duration
# of the scene, which is real time; settings that fail have no cost and stand at
# the top.
# Reads   data  tables settings, front (scene law method error ms reason),
#               scenes (scene floor), machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,640
set output out
array Scene[6] = ["slow_pull", "fast_pull", "shake", "swing", "buckle", "push"]
array Title[6] = ["slow pull", "fast pull", "shake", "release and swing", \
    "press to buckling", "push"]
array Lasts[6] = [1000, 80, 400, 30, 2000, 80] # ms, as work.h has it
array Law[3] = ["cubic", "log", "linear"]
array Color[3] = ["#D55E00", "#0072B2", "#000000"]
array Method[5] = ["static", "backward", "midpoint", "bdf2", "symplectic"]
array Name[5] = ["static", "backward Euler", "midpoint", "BDF2", \
    "symplectic Euler"]
array Point[5] = [4, 6, 8, 12, 2]
here(s) = strcol("scene") eq Scene[int(s)]
of(s, l, m) = here(s) && strcol("law") eq Law[int(l)] && \
              strcol("method") eq Method[int(m)] ? column("ms") : NaN
lost(s, l) = system(sprintf("awk -F'\t' '/^# / { t = $0 } \
    t == \"# settings\" && $1 == \"%s\" && $2 == \"%s\" && $10 != \"OK\" { n++ } \
    END { print n + 0 }' '%s'", Scene[s], Law[l], data)) + 0
# of marks within seven pixels of each other, the first
apart = sprintf("< awk -F'\t' '$0 == \"# settings\" { on = 1; next } \
    NF == 0 { on = 0 } on && ($1 == \"scene\" || $10 == \"OK\" && \
        !seen[$1, int(4 * log($7) + 99), int(4 * log($8) + 99)]++)' '%s'", data)
# of the corners those that have room for a label: half the error of the last one
corners = sprintf("< awk -F'\t' '$0 == \"# front\" { on = 1; print \"scene\\tms\\terror\\tlabel\"; next } \
    NF == 0 { on = 0 } on && $1 != \"scene\" { \
        if ($1 != scene) last = 9; scene = $1; \
        if ($7 > 0.55 * last) next; last = $7; \
        law = $2 == \"linear\" ? \"lin\" : $2; \
        how = $3 == \"static\" ? \"static \" $4 : substr($3, 1, 4) \" \" $4 \"×\" $5; \
        print $1 \"\\t\" $8 \"\\t\" $7 \"\\t\" law \" \" how }' '%s'", data)
set multiplot
set label 20 machine(data) at screen 0.01,0.012 left font ",10"
set logscale xy
set format y "10^{%T}"
set format x "10^{%T}"
set xrange [2e-3:4e3]
set yrange [1e-3:6]
set xtics 1e-2, 100, 1e4
set bars 0
do for [s = 1:6] {
    column_ = (s - 1) % 3
    row = (s - 1) / 3
    set lmargin at screen 0.08 + 0.312 * column_
    set rmargin at screen 0.08 + 0.312 * column_ + 0.275
    set tmargin at screen 0.865 - 0.395 * row
    set bmargin at screen 0.865 - 0.395 * row - 0.32
    set label 1 Title[s] at graph 0.5, 1.05 center font ",14"
    set xlabel row == 1 ? "time to the answer (ms)" : ""
    set ylabel column_ == 0 ? "relative error of u at the end" : ""
    do for [l = 1:3] {
        set label 10 + l lost(s, l) > 0 ? sprintf("× %d", lost(s, l)) : "" \
            at graph 0.36 + 0.2 * (l - 1), 0.94 textcolor rgb Color[l] \
            font ",12"
    }
    set arrow 1 from Lasts[s], graph 0 to Lasts[s], graph 0.88 nohead ls 8
    set label 14 "failed" at graph 0.08, 0.94 font ",12" \
        textcolor rgb "#555555"
    unset key
    if (s == 2) { unset label 20 }
    plot data index "scenes" using (here(s) ? 2e-3 : NaN):"floor":(3990.0):(0) \
             with vectors nohead ls 8 dt 3 notitle, \
         apart using (here(s) ? column("ms") : NaN):"error" \
             with points pt 7 ps 0.25 lc rgb "#B0B0B0" notitle, \
         data index "front" using (here(s) ? column("ms") : NaN):"error" \
             with steps lw 1.5 lc rgb "#009E73" notitle, \
         for [l = 1:3] for [m = 1:5] data index "front" \
             using (of(s, l, m)):"error" with points pt Point[m] ps 0.8 \
             lc rgb Color[l] notitle, \
         corners using (here(s) && column("ms") < 0.2 ? column("ms") : NaN):"error":(strcol("label")) \
             with labels left offset 0.7,0.5 font ",9" notitle, \
         corners using (here(s) && column("ms") >= 0.2 ? column("ms") : NaN):"error":(strcol("label")) \
             with labels right offset -0.8,-0.4 font ",9" notitle
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
set key at screen 0.52, 0.99 center top horizontal maxrows 2 samplen 1.5 \
    font ",12" reverse Left
plot for [l = 1:3] NaN with points pt 7 ps 0.9 lc rgb Color[l] title Law[l], \
     for [m = 1:5] NaN with points pt Point[m] ps 0.7 lc rgb "#555555" \
         title Name[m], \
     NaN with lines lw 2 lc rgb "#009E73" title "the front", \
     NaN with lines ls 8 title "real time"
unset multiplot
