# motion.gp - the script `hard` under the cubic law, every third frame.  The big
# dot is the pointer while the button is down, the small dots are the vertices in
# the hand, and the strip shows by which rung each frame went; hand and strip come
# from the tables `hand` and `rungs`, where these are.  With the button up the
# pointer is small and grey.  Inverted triangles are slivers, so their outlines
# are thick.
# Reads   data  table motion
# Yours   the lesson with --film 3
# Writes  out   GIF
load "figures/style.gp"
large = scalable eq "" ? gif_font : "font '".scalable.",18'"
set terminal gif animate optimize delay 10 loop 0 size 720,680 @large \
    enhanced background rgb "white"
set output out

# triangles with J > 0 (sign 1) or not (sign 0), of frame k, and a
# triangle that is a point outside, so that there is always one
frame(k, sign) = sprintf( \
    "< awk -F'\t' 'BEGIN { \
         for (k = 0; k < 3; k++) print \"9\t9\"; print \"\" } \
     /^# hand/ || $1 + 0 > %d { exit } \
     $1 == \"%d\" && ($2 > 0) == %d { print $3 \"\t\" $4; print $5 \"\t\" $6; \
         print $7 \"\t\" $8; print $3 \"\t\" $4; print \"\" }' '%s'", \
    k, k, sign, data)
pointer(k) = sprintf( \
    "< awk -F'\t' '$1 == \"%d\" { print $9 \"\t\" $10 \"\t\" $11; exit }' '%s'", \
    k, data)
# the vertices in the hand, and one far away, so that there is always one
held(k) = sprintf( \
    "< awk -F'\t' 'BEGIN { print \"9\t9\" } /^# / { on = $0 == \"# hand\" } \
     on && $1 == \"%d\" { print $2 \"\t\" $3 }' '%s'", \
    k, data)
# frame, colour of its rung, for all up to frame k
rungs(k) = sprintf( \
    "< awk -F'\t' 'BEGIN { print \"-999\t0\" } /^# / { on = $0 == \"# rungs\" } \
     on && $1 ~ /^[0-9]/ && $1 <= %d { print $1 \"\t\" \
         ($2 == \"fast\" ? 29362 : $2 == \"downhill\" ? 15113984 : 0) }' '%s'", \
    k, data)
has_rungs = system(sprintf("grep -c '^# rungs$' '%s'", data)) > 0
last = int(real(system(sprintf("awk -F'\t' '/^# hand/ { exit } \
    $1 ~ /^[0-9]+$/ { k = $1 } END { print k + 0 }' '%s'", data))))
set datafile nocolumnheaders
unset key
set size ratio -1
set tmargin 1
set border 15 back ls 9
set xrange [-2.7:2.9]
set yrange [-2.5:2.4]
set xtics 1
set ytics 1
set xlabel "x_1 (m)"
set ylabel "x_2 (m)"
set style fill solid noborder
strip(k) = -2.5 + 5.2 * k / (last + 3.0)
if (has_rungs) {
    set label 2 "first rung" at -2.5, -2.12 tc rgb "#0072B2"
    set label 3 "second rung" at -1, -2.12 tc rgb "#E69F00"
    set label 4 "lost: ".system(sprintf("grep -c 'lost$' '%s'", data)) \
        at 2.7, -2.12 right
}
set label 5 "held" at -1.08, 0.85 right front
set arrow 1 from -1, -1 to -1, 1 nohead lw 4 lc rgb "#555555" front
do for [k = 0:last:3] {
    set label 1 sprintf("t = %.1f s", k / 30.0) at graph 0.03, graph 0.96
    plot frame(k, 1) using 1:2 with filledcurves closed fc rgb "#CFE3F0", \
         frame(k, 1) using 1:2 with lines lw 1 lc rgb "#0072B2", \
         frame(k, 0) using 1:2 with filledcurves closed fc rgb "#D600BE", \
         frame(k, 0) using 1:2 with lines lw 4 lc rgb "#D600BE", \
         rungs(k) using (strip($1)):(-2.35):2 with points pt 5 ps 0.6 \
             lc rgb variable, \
         held(k) using 1:2 with points pt 7 ps 1.2 lc rgb "#D55E00", \
         pointer(k) using 1:2:($3 > 0 ? 2.6 : 1):($3 > 0 ? 13983232 : 10066329) \
             with points pt 6 lw 2 ps variable lc rgb variable
}
