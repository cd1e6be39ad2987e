# front_all.gp - as front.gp, for all six scenes: error against counted flops of every setting in six scenes (grey), the
# front, whose corners say law, method, n x steps and the element unless it is an
# even linear one, the floor of the reference, with the errors below it shaded; how
# many settings fail, and how many of these are explicit.
# Reads   data  tables settings, front (scene asked law method error flops
#               reason element grade floor; asked 0: the front, -1: that of
#               even linear triangles)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 1160,1160
set output out
array Scene[6] = ["slow_pull", "fast_pull", "shake", "swing", "buckle", "push"]
array Title[6] = ["slow pull", "fast pull", "shake", "swing (a hump let go)", \
    "buckle: n × n/8 cells", "push"]
# a panel shows errors from Low to High; its decades
array Low[6] = [3e-5, 4e-4, 3e-4, 2e-3, 1.3e-4, 3e-3]
array High[6] = [3, 2, 4, 5, 5, 0.95]
# from label to label the error falls by at least this factor
array Fall[6] = [3.3, 2.3, 2.6, 2.2, 2.8, 2.8]
room(s) = log10(High[s] / Low[s])
here(s) = strcol("scene") eq Scene[int(s)]
lost(s) = system(sprintf("awk -F'\t' '/^# / { t = $0 } \
    t == \"# settings\" && $1 == \"%s\" { all++; n += $10 != \"OK\"; \
        explicit += $10 != \"OK\" && $4 ~ /^symp/ } \
    END { print n + 0 \" of \" all \", \" (explicit == n ? \"all\" : explicit + 0) \" explicit\" }' '%s'", Scene[s], data))
known(s) = real(system(sprintf("awk -F'\t' '$0 == \"# front\" { on = 1 } \
    on && $1 == \"%s\" { print $14; exit }' '%s'", Scene[s], data)))
# of marks within seven pixels of each other, the first
apart = sprintf("< awk -F'\t' '$0 == \"# settings\" { on = 1; next } \
    NF == 0 { on = 0 } on && ($1 == \"scene\" || $10 == \"OK\" && \
        !seen[$1, int(4 * log($8) + 99), int(4 * log($9))]++)' '%s'", data)
# of the corners those that have room for a label: lower by Fall
corners(s) = sprintf("< awk -F'\t' '$0 == \"# front\" { on = 1; print \"scene\tflops\terror\tlabel\"; next } \
    NF == 0 { on = 0 } on && $1 != \"scene\" && $2 == 0 { \
        if ($1 != scene) last = 9; scene = $1; \
        if ($1 != \"%s\" || last / $8 < %g) next; last = $8; \
        element = $12 != \"linear\" ? \", quadr.\" : \"\"; \
        if ($13 > 1) element = element \", graded\"; \
        if ($1 == \"buckle\" && $4 == \"midpoint\" && $6 <= 8) element = element \" (luck)\"; \
        how = $4 == \"static\" ? \"static n = \" $5 : ($4 ~ /^symp/ ? \"sympl.\" : $4) \" \" $5 \"×\" $6; \
        print $1 \"\t\" $9 \"\t\" $8 \"\t\" $3 \" \" how element }' '%s'", Scene[s], Fall[s], data)
# the law on a line of its own, where there is no room on the left
two(s) = word(s, 1)."\n".s[strlen(word(s, 1)) + 2:*]
set multiplot
set logscale xy
set grid noxtics ytics
set format y "10^{%T}"
set format x "10^{%T}"
set xrange [4e3:2e8]
set xtics 1e4, 10, 1e8
unset key
do for [s = 1:6] {
    left = 0.5 * ((s - 1) % 2)
    top = 0.97 - 0.324 * ((s - 1) / 2)
    set lmargin at screen left + 0.065
    set rmargin at screen left + 0.485
    set tmargin at screen top
    set bmargin at screen top - 0.27
    set label 1 Title[s] at graph 0.5, 1.05 center font ",15"
    set yrange [Low[s]:High[s]]
    set xlabel s > 4 ? "flops counted" : ""
    set ylabel s % 2 ? "relative error of u at the end" : ""
    set label 2 "failed: ".lost(s) at graph 0.98, 0.95 right \
        textcolor rgb "#555555"
    set label 3 (s == 1 ? "grey: other settings, thinned" : "") at graph 0.03, 0.95 tc rgb "#777777"
    set label 4 (s == 1 ? "green: the front" : "") at graph 0.03, 0.86 tc rgb "#009E73"
    set label 7 (s == 1 ? "dotted: even, linear triangles" : "") at graph 0.03, 0.80 tc rgb "#009E73"
    set object 1 rectangle from graph 0, graph 0 to graph 1, first known(s) \
        behind fillcolor rgb "#E8E8E8" fillstyle solid noborder
    set label 6 "known to" at 6e3, known(s) * 10**(0.034 * room(s))
    plot data index "front" using (here(s) && column("asked") == 0 ? 4e3 : NaN):"floor":(2e8):(0) \
             with vectors nohead ls 8 dt 3, \
         apart using (here(s) ? column("flops") : NaN):"error" \
             with points pt 7 ps 0.25 lc rgb "#B0B0B0", \
         data index "front" using (here(s) && column("asked") == -1 ? column("flops") : NaN):"error" \
             with steps lw 2 dt 3 lc rgb "#009E73", \
         data index "front" using (here(s) && column("asked") == 0 ? column("flops") : NaN):"error" \
             with steps lw 1.5 lc rgb "#009E73", \
         data index "front" using (here(s) && column("asked") == 0 ? column("flops") : NaN):"error" \
             with points pt 7 ps 0.5 lc rgb "#009E73", \
         corners(s) using (here(s) && column("flops") < 2e4 ? column("flops") : NaN):"error":(strcol("label")) \
             with labels left offset 0.8,1.05, \
         corners(s) using (here(s) && column("flops") >= 2e4 && column("flops") < 5e4 ? column("flops") : NaN): \
             "error":(two(strcol("label"))) with labels right offset -0.8,-0.5, \
         corners(s) using (here(s) && column("flops") >= 5e4 ? column("flops") : NaN):"error":(strcol("label")) \
             with labels right offset -0.8,(s == 5 ? -0.85 : -0.5)
}
unset multiplot
