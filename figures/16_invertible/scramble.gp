# scramble.gp - a square that is wound twice round its middle vertex, and which
# law brings a scrambled square back, against its error where nothing is wrong.
# Reads   data  tables wound, stuck, scramble (n boundary law rate iterations
#               error)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,440
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
stats data index "stuck" using "energy" every ::0::0 nooutput
energy = STATS_min
stats data index "stuck" using "min_J" every ::0::0 nooutput
least = STATS_min
# the way round the boundary, drawn a little further out from vertex to vertex
array Way[9] = [0, 1, 2, 5, 8, 7, 6, 3, 0]
out_by(k) = 1.04 + 0.045 * k
sx(k) = PX[5] + out_by(k) * (PX[Way[k + 1] + 1] - PX[5])
sy(k) = PY[5] + out_by(k) * (PY[Way[k + 1] + 1] - PY[5])

set multiplot
set lmargin at screen 0.01
set rmargin at screen 0.45
set tmargin at screen 0.97
set bmargin at screen 0.03
set size ratio -1
unset key
unset border
unset tics
unset grid
set xrange [-1.85:1.25]
set yrange [-1.25:1.95]
do for [k = 0:7] {
    set arrow k + 1 from sx(k), sy(k) to sx(k + 1), sy(k + 1) \
        filled size screen 0.012,20 front lw 1.8 \
        lc rgb (k < 4 ? "#D55E00" : "#009E73")
    name_at = k < 4 ? 0.84 : out_by(k) + 0.12
    set label k + 1 sprintf("%d", Way[k + 1]) at \
        PX[5] + name_at * (PX[Way[k + 1] + 1] - PX[5]), \
        PY[5] + name_at * (PY[Way[k + 1] + 1] - PY[5]) - (k == 4 ? 0.13 : 0) \
        center front \
        font ",13" textcolor rgb (k < 4 ? "#D55E00" : "#009E73")
}
# at rest, in the corner
set label 20 "at rest" at -1.35, 1.86 center font ",12"
do for [v = 0:8] {
    set label 21 + v sprintf("%d", v) at -1.70 + 0.35 * (v % 3), \
        1.04 + 0.35 * (v / 3) center font ",12" textcolor rgb \
        (v == 4 ? "#000000" : v < 3 || v == 5 ? "#D55E00" : "#009E73")
}
set object 1 polygon from -1.62,1.12 to -1.08,1.12 to -1.08,1.66 to \
    -1.62,1.66 to -1.62,1.12 fs empty border rgb "#999999"
set label 40 sprintf("in balance, stable, every J > %.2f,\nand %.1f J/m away from rest", \
    floor(100 * least) / 100.0, energy) at -0.55,1.72 left font ",13"
sheets = sprintf( \
    "< awk -F'\t' '$0 == \"# wound\" { on = 1; next } NF == 0 { on = 0 } \
     on && $2 ~ /^[-0-9]/ { for (k = 0; k < 4; k++) \
         print $(1 + 2 * (k %% 3)) \"\t\" $(2 + 2 * (k %% 3)); print \"\" }' '%s'", \
    data)
set datafile nocolumnheaders
set style fill transparent solid 0.35 noborder
plot sheets using 1:2 with filledcurves closed fc rgb "#9CC7E2", \
     "" using 1:2 with lines lw 1 lc rgb "#0072B2"

# ---- the chart
unset arrow
unset label
unset object
set datafile columnheaders
set size noratio
set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid back ls 9
set lmargin at screen 0.56
set rmargin at screen 0.98
set tmargin at screen 0.83
set bmargin at screen 0.13
set key at screen 0.53, screen 0.985 left top vertical maxrows 3 reverse Left
# the place of an error is its root: 0 has a place, and 9 % does not rule all
set xrange [-0.3:3.5]
set yrange [0:112]
set xtics ("0" 0, "0.25" 0.5, "1" 1, "2.25" 1.5, "4" 2, "6.25" 2.5, "9" 3)
set ytics 0,25,100
set xlabel "stress error at a stretch of 1.1 (%)"
set ylabel "scrambled squares that come back (%)"
at(n, b) = column("n") == n && stringcolumn("boundary") eq b
rate(n, b) = at(n, b) ? column("rate") : NaN
many(n, b) = at(n, b) ? sprintf("%.0f", column("iterations")) : ""
set label 1 "extended" at 0.06, 68 center rotate font ",13"
set label 2 "cubic" at 0.543, 68 center rotate font ",13"
set label 3 "stable" at 3.07, 68 center rotate font ",13"
set label 4 "beside a point: iterations, the median" at 1, 8 left font ",12"
plot data index "scramble" using (sqrt(column("error"))):(rate(4, "held")) with points ls 3 \
         ps 1.3 title "n = 4, boundary held", \
     "" index "scramble" using (sqrt(column("error"))):(rate(2, "free")) with points ls 1 \
         ps 1.3 title "n = 2, all vertices scrambled", \
     "" index "scramble" using (sqrt(column("error"))):(rate(4, "free")) with points ls 2 \
         ps 1.3 title "n = 4, all vertices scrambled", \
     "" index "scramble" using (sqrt(column("error"))):(rate(2, "free")):(many(2, "free")) \
         with labels right offset -1.2,-0.4 font ",12" textcolor rgb "#0072B2" \
         notitle, \
     "" index "scramble" using (sqrt(column("error"))):(rate(4, "free")):(many(4, "free")) \
         with labels left offset 1.2,0 font ",12" textcolor rgb "#D55E00" \
         notitle
unset multiplot
set output
