# motion.gp - a free square that starts with 6 rad/s and (0.2, 0.1) m/s, each
# time step of 1/30 s per frame: it ought to spin on, as the grey square does.
# Reads   data  table motion
# Writes  out   GIF
load "figures/style.gp"
large = scalable eq "" ? gif_font : "font '".scalable.",22'"
set terminal gif animate optimize delay 7 loop 0 size 720,720 @large enhanced \
    background rgb "white"
set output out

frame(t) = sprintf( \
    "< awk -F'\t' '$0 == \"# motion\" { on = 1; next } NF == 0 { on = 0 } \
     on && $2 ~ /^[0-9]/ && ($2 - %f)^2 < 1e-6 { for (k = 0; k < 4; k++) \
         print $(4 + 2 * (k %% 3)) \"\t\" $(5 + 2 * (k %% 3)); \
         print \"\" }' '%s'", t, data)
# the path of vertex 0, which starts at (-1, -1), up to the time t
path(t) = sprintf( \
    "< awk -F'\t' -v last=-1 '$0 == \"# motion\" { on = 1; next } \
     NF == 0 { on = 0 } on && $2 <= %f && $2 != last { last = $2; print $4 \"\t\" $5 }' '%s'", \
    t + 1e-6, data)
set datafile nocolumnheaders
unset key
set tmargin 0.5
set size ratio -1
set border 15 back ls 9
set xrange [-1.8:2.4]
set yrange [-1.7:2.5]
set xtics 1
set ytics 1
set xlabel "x_1 (m)"
set ylabel "x_2 (m)" offset 1
set style fill solid noborder
# corner k of a square that keeps its 6 rad/s and its velocity
cx(k, t) = 0.2 * t + sqrt(2) * cos(6 * t + (2 * k + 1) * pi / 4)
cy(k, t) = 0.1 * t + sqrt(2) * sin(6 * t + (2 * k + 1) * pi / 4)
set label 2 "computed" at graph 0.03, graph 0.88 tc rgb "#D55E00"
set label 3 "as it ought to turn" at graph 0.97, graph 0.95 right tc rgb "#666666"
do for [m = 0:45] {
    t = m / 30.0
    set object 1 polygon from cx(0, t), cy(0, t) to cx(1, t), cy(1, t) \
        to cx(2, t), cy(2, t) to cx(3, t), cy(3, t) to cx(0, t), cy(0, t) \
        front fs empty border lc rgb "#777777" lw 2
    set object 2 circle at cx(2, t), cy(2, t) size 0.06 front \
        fs solid fc rgb "#777777"
    set label 1 sprintf("t = %.2f s", m / 30.0) at graph 0.03, graph 0.95
    plot frame(t) using 1:2 with filledcurves closed fc rgb "#CFE3F0", \
         "" using 1:2 with lines lw 1 lc rgb "#0072B2", \
         path(t) using 1:2 with lines lw 2 lc rgb "#D55E00", \
         path(t) using (x_ = $1):(y_ = $2) with points pt 7 ps 0 notitle, \
         "+" using (x_):(y_) every ::0::0 with points pt 7 ps 2.4 lc rgb "#D55E00"
}
