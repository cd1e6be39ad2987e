# front.gp - error against counted flops of every setting in six scenes (grey), the
# front, whose corners say law, method, n x steps and the element unless it is an
# even linear one, what the balance rule takes, the floor of the reference; settings that fail have no cost and stand at the top.
# Reads   data  tables settings, front (scene asked law method error flops
#               reason element grade; asked 0: the front, -1: that of even
#               linear triangles, else the rule), scenes (scene floor)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,640
set output out
array Scene[6] = ["slow_pull", "fast_pull", "shake", "swing", "buckle", "push"]
array Title[6] = ["slow pull", "fast pull", "shake", "release and swing", \
    "press to buckling", "push"]
array Law[3] = ["cubic", "log", "linear"]
array Color[3] = ["#D55E00", "#0072B2", "#000000"]
array Method[5] = ["static", "backward", "midpoint", "bdf2", "symplectic"]
array Name[5] = ["static", "backward Euler", "midpoint", "BDF2", \
    "symplectic Euler"]
array Point[5] = [4, 6, 8, 12, 2]
here(s) = strcol("scene") eq Scene[int(s)]
even(x) = strcol("element") eq "linear" && column("grade") == 1
of(s, l, m) = here(s) && even(0) && strcol("law") eq Law[int(l)] && \
              strcol("method") eq Method[int(m)] ? column("flops") : NaN
other(s, m) = here(s) && !even(0) && strcol("method") eq Method[int(m)] \
              ? column("flops") : NaN
lost(s, l) = system(sprintf("awk -F'\t' '/^# / { t = $0 } \
    t == \"# settings\" && $1 == \"%s\" && $3 == \"%s\" && $10 != \"OK\" { n++ } \
    END { print n + 0 }' '%s'", Scene[s], Law[l], data)) + 0
# of marks within seven pixels of each other, the first
apart = sprintf("< awk -F'\t' '$0 == \"# settings\" { on = 1; next } \
    NF == 0 { on = 0 } on && ($1 == \"scene\" || $10 == \"OK\" && \
        !seen[$1, int(4 * log($8) + 99), int(4 * log($9))]++)' '%s'", data)
# of the corners those that have room for a label: half the error of the last one
corners = sprintf("< awk -F'\t' '$0 == \"# front\" { on = 1; print \"scene\\tflops\\terror\\tlabel\"; next } \
    NF == 0 { on = 0 } on && $1 != \"scene\" && $2 == 0 { \
        if ($1 != scene) last = 9; scene = $1; \
        if ($8 > 0.55 * last) next; last = $8; \
        law = $3 == \"linear\" ? \"lin\" : $3; \
        element = $12 != \"linear\" ? \" quad\" : \"\"; \
        if ($13 > 1) element = element \" graded\"; \
        how = $4 == \"static\" ? \"static \" $5 : substr($4, 1, 4) \" \" $5 \"×\" $6; \
        print $1 \"\\t\" $9 \"\\t\" $8 \"\\t\" law \" \" how element }' '%s'", data)
front(s, l, m) = of(s, l, m) > 0 && column("asked") == 0 ? column("flops") : NaN
front_of_others(s, m) = other(s, m) > 0 && column("asked") == 0 ? column("flops") : NaN
set multiplot
set logscale xy
set format y "10^{%T}"
set format x "10^{%T}"
set xrange [4e3:2e8]
set yrange [1.5e-4:6]
set xtics 1e4, 100, 1e8
set bars 0
do for [s = 1:6] {
    column_ = (s - 1) % 3
    row = (s - 1) / 3
    set lmargin at screen 0.08 + 0.312 * column_
    set rmargin at screen 0.08 + 0.312 * column_ + 0.275
    set tmargin at screen 0.855 - 0.40 * row
    set bmargin at screen 0.855 - 0.40 * row - 0.32
    set label 1 Title[s] at graph 0.5, 1.05 center font ",14"
    set xlabel row == 1 ? "flops counted" : ""
    set ylabel column_ == 0 ? "relative error of u at the end" : ""
    do for [l = 1:3] {
        set label 10 + l lost(s, l) > 0 ? sprintf("× %d", lost(s, l)) : "" \
            at graph 0.36 + 0.2 * (l - 1), 0.94 textcolor rgb Color[l] \
            font ",12"
    }
    set label 14 "failed" at graph 0.08, 0.94 font ",12" \
        textcolor rgb "#555555"
    unset key
    plot data index "scenes" using (here(s) ? 4e3 : NaN):"floor":(2e8):(0) \
             with vectors nohead ls 8 dt 3 notitle, \
         apart using (here(s) ? column("flops") : NaN):"error" \
             with points pt 7 ps 0.25 lc rgb "#B0B0B0" notitle, \
         data index "front" using (here(s) && column("asked") == -1 ? column("flops") : NaN):"error" \
             with steps lw 2 dt 3 lc rgb "#009E73" notitle, \
         data index "front" using (here(s) && column("asked") == 0 ? column("flops") : NaN):"error" \
             with steps lw 1.5 lc rgb "#009E73" notitle, \
         for [l = 1:3] for [m = 1:5] data index "front" \
             using (front(s, l, m)):"error" with points pt Point[m] ps 0.8 \
             lc rgb Color[l] notitle, \
         for [m = 1:5] data index "front" \
             using (front_of_others(s, m)):"error" with points pt Point[m] \
             ps 0.8 lc rgb "#E69F00" notitle, \
         corners using (here(s) && column("flops") < 2e5 ? column("flops") : NaN):"error":(strcol("label")) \
             with labels left offset 0.7,0.5 font ",9" notitle, \
         corners using (here(s) && column("flops") >= 2e5 ? column("flops") : NaN):"error":(strcol("label")) \
             with labels right offset -0.8,-0.4 font ",9" notitle, \
         data index "front" using (here(s) && column("asked") > 0 ? column("flops") : NaN):"error" \
             with points pt 6 ps 1.4 lw 2 lc rgb "#CC79A7" notitle
}
# the key, in a plot of its own
unset label
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
     NaN with points pt 7 ps 0.9 lc rgb "#E69F00" title "other element", \
     NaN with lines lw 2 lc rgb "#009E73" title "the front", \
     NaN with lines lw 2 dt 3 lc rgb "#009E73" title "without these", \
     NaN with points pt 6 ps 1.4 lw 2 lc rgb "#CC79A7" title "balance rule"
unset multiplot
