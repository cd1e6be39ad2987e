# sheet.gp - a square that is wound twice round its middle vertex, in balance.
# Reads   data  tables sheet (energy min_J), wound
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 660,610 enhanced font "Helvetica,20" \
    background rgb "white"
set output out

# vertices 0 to 8 of the table's triangles: row and corner where each stands
array Row[9] = [0, 0, 2, 1, 0, 2, 5, 4, 6]
array Corner[9] = [0, 1, 1, 2, 2, 2, 2, 2, 2]
array PX[9]
array PY[9]
do for [v = 1:9] {
    stats data index "wound" using (column(1 + 2 * Corner[v])) \
        every ::Row[v]::Row[v] nooutput
    PX[v] = STATS_min
    stats data index "wound" using (column(2 + 2 * Corner[v])) \
        every ::Row[v]::Row[v] nooutput
    PY[v] = STATS_min
}
# turned about vertex 4, so that vertex 0 is on the left
turn = pi - atan2(PY[1] - PY[5], PX[1] - PX[5])
tx(x, y) = cos(turn) * (x - PX[5]) - sin(turn) * (y - PY[5])
ty(x, y) = sin(turn) * (x - PX[5]) + cos(turn) * (y - PY[5])
array TX[9]
array TY[9]
do for [v = 1:9] {
    TX[v] = tx(PX[v], PY[v])
    TY[v] = ty(PX[v], PY[v])
}
stats data index "sheet" using "energy" every ::0::0 nooutput
energy = STATS_min
stats data index "sheet" using "min_J" every ::0::0 nooutput
least = STATS_min
# the way round the boundary, drawn a little further out from vertex to vertex
array Way[9] = [0, 1, 2, 5, 8, 7, 6, 3, 0]
out_by(k) = 1.04 + 0.045 * k
sx(k) = out_by(k) * TX[Way[k + 1] + 1]
sy(k) = out_by(k) * TY[Way[k + 1] + 1]

set lmargin at screen 0.01
set rmargin at screen 0.99
set tmargin at screen 0.99
set bmargin at screen 0.01
set size ratio -1
unset key
unset border
unset tics
unset grid
set xrange [-2.15:1.85]
set yrange [-1.4:2.2]
do for [k = 0:7] {
    if (k < 4) {
        set arrow k + 1 from sx(k), sy(k) to sx(k + 1), sy(k + 1) \
            filled size screen 0.02,20 front lw 2.5 lc rgb "#000000"
    } else {
        set arrow k + 1 from sx(k), sy(k) to sx(k + 1), sy(k + 1) \
            filled size screen 0.02,20 front lw 2.5 dt 2 lc rgb "#AA3377"
    }
    # the two vertices that lie on one another, outside the arrows
    corner = k % 4
    set label k + 1 sprintf("%d", Way[k + 1]) at \
        1.55 * TX[Way[corner + 1] + 1] + (k < 4 ? -0.1 : 0.1) - 0.13 * (corner == 0), \
        1.55 * TY[Way[corner + 1] + 1] center front \
        textcolor rgb (k < 4 ? "#000000" : "#AA3377")
}
set label 9 "4" at 0, 0.01 center front
set object 2 circle at 0, 0 size 0.1 front fc rgb "white" \
    fs solid border lc rgb "black"
# at rest, in the corner
set label 20 "at rest" at -1.50, 2.05 center
do for [v = 0:8] {
    set label 21 + v sprintf("%d", v) at -1.95 + 0.45 * (v % 3), \
        0.90 + 0.43 * (v / 3) center front \
        textcolor rgb (v < 3 || v == 4 || v == 5 ? "#000000" : "#AA3377")
}
set object 1 polygon from -1.81,1.03 to -1.19,1.03 to -1.19,1.63 to \
    -1.81,1.63 to -1.81,1.03 fs empty border rgb "#999999"
set object 3 circle at -1.50, 1.33 size 0.1 front fc rgb "white" \
    fs solid border lc rgb "black"
# ... with its triangles, of which six are round vertex 4
rx(v) = -1.81 + 0.31 * (v % 3)
ry(v) = 1.03 + 0.30 * (v / 3)
do for [k = 1:5] {
    a = word("1 3 0 1 3", k) + 0
    b = word("7 5 8 5 7", k) + 0
    set arrow 20 + k from rx(a), ry(a) to rx(b), ry(b) nohead lc rgb "#BBBBBB"
}
set label 40 sprintf("cubic law: a minimum,\nevery J > %.2f, %.1f J/m", \
    floor(100 * least) / 100.0, energy) at -0.55,2.0 left
sheets = sprintf( \
    "< awk -F'\t' '$0 == \"# wound\" { on = 1; next } NF == 0 { on = 0 } \
     on && $2 ~ /^[-0-9]/ { for (k = 0; k < 4; k++) \
         print $(1 + 2 * (k %% 3)) \"\t\" $(2 + 2 * (k %% 3)); print \"\" }' '%s'", \
    data)
set datafile nocolumnheaders
set style fill transparent solid 0.35 noborder
plot sheets using (tx($1, $2)):(ty($1, $2)) \
         with filledcurves closed fc rgb "#9CC7E2", \
     "" using (tx($1, $2)):(ty($1, $2)) with lines lw 1 lc rgb "#0072B2"
set output
