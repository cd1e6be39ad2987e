# loop.gp - a schematic: the loop that makes a picture of the user's hand in
# every thirtieth of a second, and what it does when a frame cannot be solved.
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,430 enhanced font "Helvetica,16"
set output out
unset key
unset grid
unset tics
unset border
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
set xrange [0:680]         # pixels
set yrange [0:430]
set style fill solid 1 border lc rgb "black"

# box NUMBER, its left lower corner, width, height, colour, one or two lines
i = 0
box(x, y, w, h, c, a, b) = sprintf("i = i + 1; \
    set object i rect from %g, %g to %g, %g fc rgb '%s' lw 1.2; \
    set label 2 * i '%s' at %g, %g center front; \
    set label 2 * i + 1 '%s' at %g, %g center front font 'Helvetica,14'", \
    x, y, x + w, y + h, c, a, x + w / 2, y + h / 2 + (b eq "" ? 0 : 9), \
    b, x + w / 2, y + h / 2 - 10)
grey = "#EEEEEE"
blue = "#CFE3F0"
orange = "#F7D9C4"
eval box(8.0, 340.0, 150.0, 56.0, grey, "read the hand", "boundary values g")
eval box(195.0, 340.0, 240.0, 56.0, blue, "FAST", "motion goes on, kept factors")
eval box(195.0, 236.0, 240.0, 56.0, blue, "ROBUST", "last state, search, projection")
eval box(195.0, 132.0, 240.0, 56.0, blue, "ROBUST in 2, 4, 8 parts", \
    "the hand in smaller steps")
eval box(195.0, 28.0, 240.0, 56.0, orange, "keep the old state", \
    "count the frame as lost")
eval box(503.0, 184.0, 170.0, 56.0, grey, "show it", "then the next frame")

set style arrow 1 lw 1.8 lc rgb "black" head filled size 10, 20
set style arrow 2 lw 1.8 lc rgb "black" nohead
set style arrow 3 lw 1.8 lc rgb "#D55E00" head filled size 10, 20
set style arrow 4 lw 1.8 lc rgb "#D55E00" nohead
set arrow from 158, 368 to 194, 368 as 1
do for [k = 0:2] {
    set arrow from 315, 340 - 104 * k to 315, 293 - 104 * k as 3
    set label "fails" at 326, 316 - 104 * k left tc rgb "#D55E00"
    set arrow from 435, 368 - 104 * k to 472, 368 - 104 * k as 2
    set label "OK" at 440, 380 - 104 * k left
}
set arrow from 472, 368 to 472, 160 as 2
set arrow from 472, 212 to 502, 212 as 1
set arrow from 435, 56 to 472, 56 as 4
set arrow from 472, 56 to 472, 159 as 4
# and again
set arrow from 590, 240 to 590, 416 as 2
set arrow from 590, 416 to 83, 416 as 2
set arrow from 83, 416 to 83, 397 as 1
plot NaN notitle
