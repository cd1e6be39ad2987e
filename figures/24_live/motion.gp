# motion.gp - the script `hard` under the cubic law, every third frame; the dot
# is the pointer, full while the button is down.
# Reads   data  table motion
# Yours   the lesson with --film 3
# Writes  out   GIF
load "figures/style.gp"
set terminal gif animate delay 10 loop 0 size 360,310 medium noenhanced \
    background rgb "white"
set output out

# triangles with J > 0 (sign 1) or not (sign 0), of frame k, and a
# triangle that is a point, so that there is always one
frame(k, sign) = sprintf( \
    "< awk -F'\t' 'BEGIN { \
         for (k = 0; k < 3; k++) print \"-1\t-1\"; print \"\" } $1 + 0 > %d { exit } \
     $1 == \"%d\" && ($2 > 0) == %d { print $3 \"\t\" $4; print $5 \"\t\" $6; \
         print $7 \"\t\" $8; print $3 \"\t\" $4; print \"\" }' '%s'", \
    k, k, sign, data)
pointer(k) = sprintf( \
    "< awk -F'\t' '$1 == \"%d\" { print $9 \"\t\" $10 \"\t\" $11; exit }' '%s'", \
    k, data)
last = int(real(system(sprintf("awk -F'\t' '$1 ~ /^[0-9]+$/ { k = $1 } \
    END { print k + 0 }' '%s'", data))))
set datafile nocolumnheaders
unset key
set size ratio -1
set border 15 back ls 9
set xrange [-2.7:2.9]
set yrange [-2.2:2.2]
set xtics 1
set ytics 1
set xlabel "x1 (m)"
set ylabel "x2 (m)"
set style fill solid noborder
do for [k = 0:last:3] {
    set label 1 sprintf("t = %.1f s", k / 30.0) at graph 0.04, graph 0.95
    plot frame(k, 1) using 1:2 with filledcurves closed fc rgb "#CFE3F0", \
         frame(k, 0) using 1:2 with filledcurves closed fc rgb "#D600BE", \
         frame(k, 1) using 1:2 with lines lw 1 lc rgb "#0072B2", \
         pointer(k) using 1:2:($3 > 0 ? 1.4 : 0.7) with points pt 7 \
             ps variable lc rgb "#D55E00"
}
