# square.gp - the user's square at the end of three motions, coloured by J.
# Reads   data  table square (k motion X Y u_x u_y)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,290 enhanced font "Helvetica,17" background rgb "white"
set output out
table = "square"
load "figures/square.gp"
unset cblabel
array Motion[3] = ["pull", "shake", "push"]
array At[3] = [1, 3, 5]
# the left and the right end of what each panel shows
array From[3] = [-1.08, -1.08, -1.08]
array To[3] = [1.97, 1.97, 0.0]
unset border
unset xtics
unset ytics
set multiplot
set tmargin at screen 0.88
set bmargin at screen 0.02
left = 0.0
do for [i = 1:3] {
    k = "".At[i]
    if (i == 3) {
        set colorbox user origin screen 0.90, screen 0.16 \
            size screen 0.018, screen 0.6
    } else { unset colorbox }
    wide = 0.123 * (To[i] - From[i])
    set lmargin at screen left
    set rmargin at screen left + wide
    left = left + wide
    set label 2 "J" at screen 0.909, screen 0.85 center
    set label 1 Motion[i] at -1, graph 1.04 left
    set xrange [From[i]:To[i]]
    set yrange [-1.4:1.66]
    plot @SQUARE
}
unset multiplot
