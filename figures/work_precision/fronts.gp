# fronts.gp - error against milliseconds of every setting in two scenes (grey), the front, whose
# corners say law, method, n x steps, the floor of the reference, and the duration
# of the scene, which is real time; how many settings fail.
# Reads   data  tables settings, front (scene law method error ms reason),
#               scenes (scene floor), machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,760
set output out
array Scene[2] = ["slow_pull", "shake"]
array Title[2] = ["slow pull", "shake"]
array Lasts[2] = [1000, 400] # ms, as work.h has it
array Least[2] = [1e-3, 5e-3] # and the largest error that a panel shows
array Most[2] = [0.3, 2]
here(s) = strcol("scene") eq Scene[int(s)]
lost(s) = system(sprintf("awk -F'\t' '/^# / { t = $0 } \
    t == \"# settings\" && $1 == \"%s\" { all++; n += $10 != \"OK\" } \
    END { print n + 0 \" of \" all }' '%s'", Scene[s], data))
# of marks within seven pixels of each other, the first
apart = sprintf("< awk -F'\t' '$0 == \"# settings\" { on = 1; next } \
    NF == 0 { on = 0 } on && ($1 == \"scene\" || $10 == \"OK\" && \
        !seen[$1, int(4 * log($7) + 99), int(4 * log($8) + 99)]++)' '%s'", data)
# of the corners those that have room for a label: 0.35 of the error of the last one;
# and, below it on the right, the last one if it is explicit
corners = sprintf("< awk -F'\t' '$0 == \"# front\" { on = 1; print \"scene\\tms\\terror\\tlabel\"; next } \
    NF == 0 { on = 0 } on && $1 != \"scene\" { \
        if ($1 != scene) last = 9; scene = $1; \
        if ($7 > 0.35 * last) next; last = $7; \
        how = $3 == \"static\" ? \"static n = \" $4 : $3 \" \" $4 \"×\" $5; \
        print $1 \"\\t\" $8 \"\\t\" $7 \"\\t\" $2 \" \" how }' '%s'", data)
explicit = system(sprintf("awk -F'\t' '$0 == \"# front\" { on = 1 } NF == 0 { on = 0 } \
    on && $1 == \"shake\" { row = $8 \" \" $7 \" \" $2 \" \" $4 \"×\" $5; \
        last = $3 ~ /^symp/ } END { if (last) print row }' '%s'", data))
# above the marks on the right of a corner
raised(s) = s == 2 ? 1 : column("error") > 0.02 ? 1.4 : 1.16
set multiplot
set label 20 machine(data) at screen 0.99,0.99 right textcolor rgb "#555555"
set logscale xy
set grid noxtics ytics
set format y "10^{%T}"
set format x "10^{%T}"
set xrange [2e-3:2e3]
set xtics 1e-2, 10, 1e4
unset key
do for [s = 1:2] {
    set lmargin at screen 0.13
    set rmargin at screen 0.97
    set tmargin at screen 0.935 - 0.475 * (s - 1)
    set bmargin at screen 0.935 - 0.475 * (s - 1) - 0.395
    set label 1 Title[s] at graph 0.5, 1.05 center font ",15"
    set yrange [Least[s]:Most[s]]
    set xlabel s == 2 ? "time to the answer (ms)" : ""
    set ylabel "relative error of u at the end"
    set label 2 "failed: ".lost(s) at graph 0.03, 0.06 \
        textcolor rgb "#555555"
    set label 3 (s == 1 ? "grey: other settings, thinned" : "") at graph 0.03, 0.95 tc rgb "#777777"
    set label 4 (s == 1 ? "green: the front" : "") at graph 0.03, 0.88 tc rgb "#009E73"
    set label 5 "real time" at Lasts[s], graph 0.95 right offset -0.5, 0
    if (s == 2 && words(explicit) == 4) {
        set label 6 word(explicit, 3)." sympl. ".word(explicit, 4) \
            at real(word(explicit, 1)), real(word(explicit, 2)) left offset 0.6,-0.9 font ",13"
    }
    set arrow 1 from Lasts[s], graph 0 to Lasts[s], graph 1 nohead ls 8
    plot data index "scenes" using (here(s) ? 2e-3 : NaN):"floor":(3990.0):(0) \
             with vectors nohead ls 8 dt 3, \
         apart using (here(s) ? column("ms") : NaN):"error" \
             with points pt 7 ps 0.25 lc rgb "#B0B0B0", \
         data index "front" using (here(s) ? column("ms") : NaN):"error" \
             with steps lw 1.5 lc rgb "#009E73", \
         data index "front" using (here(s) ? column("ms") : NaN):"error" \
             with points pt 7 ps 0.5 lc rgb "#009E73", \
         corners using (here(s) && column("ms") < 0.4 ? column("ms") : NaN):(column("error") * raised(s)):(strcol("label")) \
             with labels left offset 0.8,0.5 font ",13", \
         corners using (here(s) && column("ms") >= 0.4 ? column("ms") : NaN):"error":(strcol("label")) \
             with labels right offset -0.8,-0.5 font ",13"
    unset label 20
}
unset multiplot
