# readings.gp - the five readings of the notes' example at two times, n = 6,
# cubic law; triangles coloured by J, dashed the square at rest.
# Reads   data  table gallery
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,1040 enhanced font "Helvetica,18" \
    background rgb "white"
set output out

# The triangles of one scene at one time, closed.
triangles(scene, t) = sprintf( \
    "< awk -F'\t' '$0 == \"# gallery\" { on = 1; next } NF == 0 { on = 0 } \
     on && $1 == \"%s\" && ($2 - %f)^2 < 1e-6 { \
         print $4, $5, $3; print $6, $7, $3; \
         print $8, $9, $3; print $4, $5, $3; print \"\"; print \"\" }' '%s'", \
    scene, t, data)

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
array Name[5] = ["rigid", "both", "stretch", "compress", "steady"]
set multiplot
do for [row = 1:5] { do for [frame = 1:2] {
    set lmargin at screen 0.125 + 0.33 * (frame - 1)
    set rmargin at screen 0.445 + 0.33 * (frame - 1)
    set tmargin at screen 0.97 - 0.176 * (row - 1)
    set bmargin at screen 0.97 - 0.176 * (row - 1) - 0.168
    set label 1 row == 1 ? sprintf("t = %.1f s", frame / 2.0) : "" \
        at graph 0.5, graph 1.06 center
    set label 2 frame == 1 ? Name[row] : "" at graph 0.04, graph 0.93
    set ylabel frame == 1 ? "x_2  (m)" : ""
    set format y frame == 1 ? "%g" : ""
    set xlabel row == 5 ? "x_1  (m)" : ""
    set format x row == 5 ? "%g" : ""
    if (row == 5 && frame == 2) {
        set colorbox user origin screen 0.85, screen 0.30 \
            size screen 0.022, screen 0.40
        set label 9 "J" at screen 0.861, screen 0.725 center
        set cbtics 0.5
    }
    set object 1 polygon from -1, -1 to 1, -1 to 1, 1 to -1, 1 to -1, -1 \
        front fs empty border lc rgb "#777777" dt 2
    plot triangles(Name[row], frame / 2.0) using 1:2:3 \
             with filledcurves closed fc palette, \
         triangles(Name[row], frame / 2.0) using 1:2 with lines lw 0.4 \
             lc rgb "black"
} }
unset multiplot
