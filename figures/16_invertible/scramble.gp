# scramble.gp - a square that is wound twice round its middle vertex, and which
# law brings a scrambled square back, against its error where nothing is wrong.
# Reads   data  tables wound, stuck, scramble (n boundary law rate
#               standard_error iterations error)
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
stats data index "scramble" using (stringcolumn("law") eq "cubic" ? \
    column("error") : NaN) name "CUBIC" nooutput
stats data index "scramble" using (stringcolumn("law") eq "stable" ? \
    column("error") : NaN) name "STABLE" nooutput
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
set tmargin at screen 0.92
set bmargin at screen 0.17
unset key
# three bars for each law, the worse its error the further to the right
set xrange [-0.6:2.6]
set yrange [0:112]
set xtics nomirror ("extended\n0 %%" 0, sprintf("cubic\n%.2f %%%%", CUBIC_max) 1, \
    sprintf("stable\n%.1f %%%%", STABLE_max) 2)
set ytics nomirror 0,25,100
set xlabel "law; its stress error at a stretch of 1.1" offset 0,-0.8
set ylabel "scrambled squares that come back (%)"
array N[3] = [4, 2, 4]
array Boundary[3] = ["held", "free", "free"]
array Style[3] = [3, 1, 2]
array Colour[3] = ["#009E73", "#0072B2", "#D55E00"]
place(k) = (stringcolumn("law") eq "extended" ? 0 : \
    stringcolumn("law") eq "cubic" ? 1 : 2) + 0.26 * (k - 2)
rate(k) = column("n") == N[k] && stringcolumn("boundary") eq Boundary[k] ? \
    column("rate") : NaN
unsure(k) = column("standard_error")
set style fill solid 0.85 border
set boxwidth 0.22
set label 2 "n = 4, boundary held" at -0.26, 5 rotate by 90 front tc rgb "white"
set label 3 "n = 2, all scrambled" at 0, 5 rotate by 90 front tc rgb "white"
set label 4 "n = 4, all" at 0.26, 48 rotate by 90 tc rgb Colour[3]
set label 1 "above a bar: iterations, the median" at graph 0.99, graph 1.03 \
    right font ",12"
plot for [k = 1:3] data index "scramble" using (place(k)):(rate(k)) \
         with boxes ls Style[k], \
     for [k = 1:3] data index "scramble" using (place(k)): \
         (rate(k) - unsure(k)):(0):(2 * unsure(k)) with vectors heads \
         size graph 0.012,90 lw 1.5 lc rgb "black" notitle, \
     for [k = 1:3] data index "scramble" using (place(k)):(rate(k) + 6): \
         (sprintf("%.0f", column("iterations"))) with labels font ",12" \
         textcolor rgb Colour[k] notitle
unset multiplot
set output
