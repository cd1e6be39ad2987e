# recover.gp - a scrambled square is let go under three laws, every second time
# step of 1/240 s a frame; triangles that are inside out are orange.
# Reads   data  tables motion, end (law energy min_J winding)
# Writes  out   GIF
load "figures/style.gp"
large = scalable eq "" ? gif_font : "font '".scalable.",18'"
set terminal gif animate delay 9 loop 0 size 720,300 @large noenhanced \
    background rgb "white"
set output out

frame(law, state, t) = sprintf( \
    "< awk -F'\t' '$0 == \"# motion\" { on = 1; next } NF == 0 { on = 0 } \
     on && $1 == \"%s\" && $2 == %d && (\"%s\" == \"all\" || $3 == \"%s\") { \
         for (k = 0; k < 4; k++) \
             print $(4 + 2 * (k %% 3)) \"\t\" $(5 + 2 * (k %% 3)); \
         print \"\"; n++ } END { if (!n) for (k = 0; k < 3; k++) \
         print 9 \"\t\" 9 }' '%s'", \
    law, t, state, state, data)
array Law[3] = ["cubic", "extended", "stable"]
array End[3] = [": wound", ": wound", ": back"]
set datafile nocolumnheaders
unset key
set size ratio -1
set border 15 back ls 9
set xrange [-1.85:1.75]
set yrange [-1.85:1.75]
unset xtics
unset ytics
unset grid
set tmargin at screen 0.88
set bmargin at screen 0.13
set style fill transparent solid 0.5 noborder
do for [m = 0:40] {
    t = 2 * (m < 37 ? m : 36)
    set multiplot
    do for [k = 1:3] {
        set lmargin at screen 0.02 + 0.33 * (k - 1)
        set rmargin at screen 0.32 + 0.33 * (k - 1)
        set xlabel Law[k].(t == 72 ? End[k] : "")
        if (k == 1) { set label 1 sprintf("t = %.3f s", t / 240.0) at \
            screen 0.02, screen 0.94 } else { unset label 1 }
        plot frame(Law[k], "upright", t) using 1:2 with filledcurves closed \
                 fc rgb "#9CC7E2", \
             frame(Law[k], "inside_out", t) using 1:2 \
                 with filledcurves closed fc rgb "#F0A060", \
             frame(Law[k], "all", t) using 1:2 with lines lw 1 lc rgb "#0072B2"
    }
    unset multiplot
}
