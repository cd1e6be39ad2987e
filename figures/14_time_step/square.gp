# square.gp - the user's square at the end of three motions, coloured by J.
# Reads   data  table square (k motion X Y u_x u_y)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,260
set output out
table = "square"
load "figures/square.gp"
array Motion[3] = ["pull", "shake", "push"]
array At[3] = [1, 3, 5]
unset border
unset xtics
unset ytics
set multiplot
set tmargin at screen 0.88
set bmargin at screen 0.02
do for [i = 1:3] {
    k = "".At[i]
    if (i == 3) {
        set colorbox user origin screen 0.90, screen 0.16 \
            size screen 0.014, screen 0.58
    } else { unset colorbox }
    set lmargin at screen 0.005 + 0.30 * (i - 1)
    set rmargin at screen 0.30 + 0.30 * (i - 1)
    set label 1 Motion[i] at -1, graph 1.05 left
    set xrange [-1.3:2.1]
    set yrange [-1.5:1.5]
    plot @SQUARE
}
unset multiplot
