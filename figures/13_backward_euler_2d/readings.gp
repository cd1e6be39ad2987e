# readings.gp - four scenes at three times, n = 6, cubic law; triangles coloured
# by J.
# Reads   data  table gallery
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,940
set output out

# The triangles of one scene at one time, each as a surface of 2 x 2 points.
triangles(scene, t) = sprintf( \
    "< awk -F'\t' '$0 == \"# gallery\" { on = 1; next } NF == 0 { on = 0 } \
     on && $1 == \"%s\" && ($2 - %f)^2 < 1e-6 { \
         print $4, $5, $3; print $6, $7, $3; print \"\"; \
         print $8, $9, $3; print $8, $9, $3; print \"\"; print \"\" }' '%s'", \
    scene, t, data)

set datafile nocolumnheaders
set datafile separator whitespace
set palette defined (0.5 "#8C3A00", 0.7 "#D55E00", 0.85 "#F5B98F", \
                     1 "#FFFFFF", 1.15 "#A8D0EA", 1.3 "#0072B2", 1.5 "#003A5C")
set cbrange [0.5:1.5]
set pm3d map corners2color c1 border lc rgb "black" lw 0.35
unset key
unset grid
unset colorbox
set size ratio -1
set xrange [-1.95:1.95]
set yrange [-1.95:1.95]
set border 15 front ls 9
set xtics 1 scale 0.5
set ytics 1 scale 0.5
set format "%g"
array Name[4] = ["stretch", "compress", "gravity", "spin"]
set multiplot
do for [row = 1:4] { do for [frame = 1:3] {
    set lmargin at screen 0.09 + 0.27 * (frame - 1)
    set rmargin at screen 0.34 + 0.27 * (frame - 1)
    set tmargin at screen 0.965 - 0.231 * (row - 1)
    set bmargin at screen 0.965 - 0.231 * (row - 1) - 0.205
    unset label
    if (row == 1) {
        set label 1 sprintf("t = %.2f s", frame / 3.0) at graph 0.5, graph 1.09 \
            center }
    if (frame == 1) {
        set label 2 Name[row] at graph 0.04, graph 0.92 front
        set ylabel "{x_2} (m)" offset -0.5
        set format y "%g" } else { unset ylabel
        set format y "" }
    if (row == 4) { set xlabel "{x_1} (m)" offset 0, 0.3
        set format x "%g" } else { unset xlabel
        set format x "" }
    if (row == 4 && frame == 3) {
        set colorbox user origin screen 0.905, screen 0.30 \
            size screen 0.022, screen 0.40
        set cblabel "J = det F" offset 0.5
        set cbtics 0.25 }
    splot triangles(Name[row], frame / 3.0) using 1:2:3 with pm3d
} }
unset multiplot
