# scramble.gp - a square that is wound twice round its middle vertex, and which
# law brings a scrambled square back, against its error where nothing is wrong.
# Reads   data  tables wound, stuck, scramble (n boundary law recovered
#               rate standard_error iterations error)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,1010 enhanced font "Helvetica,20" \
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
set rmargin at screen 0.99
set tmargin at screen 0.99
set bmargin at screen 0.46
set size ratio -1
unset key
unset border
unset tics
unset grid
set xrange [-2.25:1.35]
set yrange [-1.45:2.25]
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
        PX[5] + 1.55 * (PX[Way[corner + 1] + 1] - PX[5]) + (k < 4 ? -0.1 : 0.1) - 0.13 * (corner == 0), \
        PY[5] + 1.55 * (PY[Way[corner + 1] + 1] - PY[5]) center front \
        textcolor rgb (k < 4 ? "#000000" : "#AA3377")
}
set label 9 "4" at PX[5], PY[5] + 0.01 center front
set object 2 circle at PX[5], PY[5] size 0.1 front fc rgb "white" \
    fs solid border lc rgb "black"
# at rest, in the corner
set label 20 "at rest" at -1.45, 2.13 center
do for [v = 0:8] {
    set label 21 + v sprintf("%d", v) at -1.90 + 0.45 * (v % 3), \
        1.00 + 0.43 * (v / 3) center textcolor rgb \
        (v == 4 ? "#777777" : v < 3 || v == 5 ? "#000000" : "#AA3377")
}
set object 1 polygon from -1.76,1.13 to -1.14,1.13 to -1.14,1.73 to \
    -1.76,1.73 to -1.76,1.13 fs empty border rgb "#999999"
set label 40 sprintf("cubic law: a minimum,\nevery J > %.2f, %.1f J/m", \
    floor(100 * least) / 100.0, energy) at -0.55,1.95 left
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
set grid noxtics ytics back ls 9
set lmargin at screen 0.15
set rmargin at screen 0.98
set tmargin at screen 0.42
set bmargin at screen 0.115
unset key
# four bars for each law, the worse its error the further to the right
set xrange [-0.6:2.6]
set yrange [0:133]
set xtics nomirror ("extended\n0 %%" 0, sprintf("cubic\n%.2f %%%%", CUBIC_max) 1, \
    sprintf("stable\n%.1f %%%%", STABLE_max) 2)
set ytics nomirror 0,25,100
set xlabel "law; stress error at a stretch of 1.1" offset 0,-0.8
set ylabel "squares that come back (%)" offset 1
array N[4] = [4, 2, 4, 8]
array Boundary[4] = ["held", "free", "free", "free"]
array Style[4] = [3, 1, 2, 4]
array Colour[4] = ["#009E73", "#0072B2", "#D55E00", "#CC79A7"]
place(k) = (stringcolumn("law") eq "extended" ? 0 : \
    stringcolumn("law") eq "cubic" ? 1 : 2) + 0.21 * (k - 2.5)
rate(k) = column("n") == N[k] && stringcolumn("boundary") eq Boundary[k] ? \
    column("rate") : NaN
unsure(k) = column("standard_error")
from(k) = rate(k) > unsure(k) ? rate(k) - unsure(k) : rate(k) * 0
# a median of one or two squares is none
iterations(k) = column("recovered") > 9 ? rate(k) + 6 : NaN
set style fill solid 0.85 border
set boxwidth 0.18
set label 1 "held, n = 4" at -0.42, 125 left tc rgb Colour[1]
set label 2 "free, n = 2" at -0.19, 110 left tc rgb Colour[2]
set label 3 "free,\nn = 4" at 0.02, 68 left tc rgb Colour[3] front boxed
set label 4 "number on a bar: iterations of the\nsquares that come back (median)" at 2.58, 127 right font ",18"
set label 5 "free,\nn = 8" at 0.235, 30 left tc rgb Colour[4] front boxed
set style textbox opaque noborder margins 0.3,0.3
plot for [k = 1:4] data index "scramble" using (place(k)):(rate(k)) \
         with boxes ls Style[k], \
     for [k = 1:4] data index "scramble" using (place(k)): \
         (from(k)):(0):(rate(k) + unsure(k) - from(k)) with vectors heads \
         size graph 0.012,90 lw 1.5 lc rgb "black" notitle, \
     for [k = 1:4] data index "scramble" using (place(k)):(iterations(k)): \
         (sprintf("%.0f", column("iterations"))) with labels font ",18" \
         textcolor rgb Colour[k] notitle
unset multiplot
set output
