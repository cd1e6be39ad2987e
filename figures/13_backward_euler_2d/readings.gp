# readings.gp - four scenes at three times, n = 6, cubic law; triangles coloured
# by J, a dot on one vertex to see the body turn.
# Reads   data  table gallery
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,860
set output out

# The triangles of one scene at one time, closed; `first`: the first alone.
triangles(scene, t, first) = sprintf( \
    "< awk -F'\t' '$0 == \"# gallery\" { on = 1; next } NF == 0 { on = 0 } \
     on && $1 == \"%s\" && ($2 - %f)^2 < 1e-6 && (!%d || !n++) { \
         print $4, $5, $3; print $6, $7, $3; \
         print $8, $9, $3; print $4, $5, $3; print \"\"; print \"\" }' '%s'", \
    scene, t, first, data)

set datafile nocolumnheaders
set datafile separator whitespace
set palette defined (0.5 "#003A5C", 0.7 "#0072B2", 0.85 "#A8D0EA", \
                     1 "#FFFFFF", 1.15 "#F5B98F", 1.3 "#D55E00", 1.5 "#8C3A00")
set cbrange [0.5:1.5]
set style fill solid noborder
unset key
unset grid
unset colorbox
set size ratio -1
set xrange [-1.8:1.8]
set yrange [-1.95:1.65]
set xtics 1
set ytics 1
array Name[4] = ["stretch", "compress", "gravity", "spin"]
set multiplot
do for [row = 1:4] { do for [frame = 1:3] {
    set lmargin at screen 0.085 + 0.262 * (frame - 1)
    set rmargin at screen 0.335 + 0.262 * (frame - 1)
    set tmargin at screen 0.965 - 0.228 * (row - 1)
    set bmargin at screen 0.965 - 0.228 * (row - 1) - 0.218
    set label 1 row == 1 ? sprintf("t = %.2f s", frame / 3.0) : "" \
        at graph 0.5, graph 1.06 center
    set label 2 frame == 1 ? Name[row] : "" at graph 0.04, graph 0.95
    set ylabel frame == 1 ? "x_2 (m)" : ""
    set format y frame == 1 ? "%g" : ""
    set xlabel row == 4 ? "x_1 (m)" : ""
    set format x row == 4 ? "%g" : ""
    if (row == 4 && frame == 3) {
        set colorbox user origin screen 0.88, screen 0.30 \
            size screen 0.022, screen 0.40
        set cblabel "J = det F" offset 0.5
        set cbtics 0.25
    }
    plot triangles(Name[row], frame / 3.0, 0) using 1:2:3 \
             with filledcurves closed fc palette, \
         triangles(Name[row], frame / 3.0, 0) using 1:2 with lines lw 0.4 \
             lc rgb "black", \
         triangles(Name[row], frame / 3.0, 1) every ::0::0 using 1:2 \
             with points pt 7 ps 0.8 lc rgb "black"
} }
unset multiplot
