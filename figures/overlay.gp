# overlay.gp - a student's numbers over the reference's, for make plot-NN.
#
# Given with gnuplot -e: data, the curves of tests/tools/plot.awk, with its
# settings beside them in data.gp; out (the SVG, or "" for the terminal).

load "figures/style.gp"
load data.".gp"
terminal = out eq ""
if (terminal) {
    set terminal dumb 78 22 nofeed
    set border 3 front linetype -1
    set tics textcolor default
    unset grid
    set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03
} else {
    set terminal svg size 640,640
    set output out
    set multiplot
    set origin 0, 0.36
    set size 1, 0.64
}
set key noenhanced samplen 3
set xlabel x_name noenhanced
if (terminal) { set title y_name noenhanced } \
else { set ylabel y_name noenhanced }
set lmargin 12
if (log_x) { set logscale x }
if (log_y) { set logscale y; set format y "%.0e" }
if (leaves) { set yrange [bottom:top] }

# In the terminal mine are a few letters, so that the line of the reference is
# seen between them; in the picture the reference lies over mine.
letters = "a b c d e f g h i j k l m n o p q r s t"
letter(k) = keyed ? word(letters, k % 20 + 1) : "o"
few = longest > 26 ? longest / 26 : 1
if (terminal) {
    plot for [k = 0:curves - 1] data index k using 3:4 with lines lt 0 \
             title k ? "" : "reference", \
         for [k = 0:curves - 1] data index k using 1:7 with points \
             pt letter(k) title columnhead(2)
} else {
    plot for [k = 0:curves - 1] data index k using 1:2 with linespoints \
             ls k % 6 + 1 pi few title columnhead(2), \
         for [k = 0:curves - 1] data index k using 3:4 with lines ls 8 \
             title k ? "" : "reference"
}

# the difference, and what the check allows
if (pairs) {
    set xrange [GPVAL_X_MIN:GPVAL_X_MAX]
    unset offsets
    unset logscale y
    set logscale y
    set format y "%.0e"
    set yrange [low * (low / high) ** 0.1:high * 5]
    if (terminal) { unset title } else { set ylabel "|mine - reference|" }
    allowed = compared ? "what the check allows" : ""
    if (terminal) {
        set terminal dumb 78 14 nofeed
        plot for [k = 0:curves - 1] data index k using 3:6 with lines lt 0 \
                 title k ? "" : allowed, \
             for [k = 0:curves - 1] data index k using 3:5 with points \
                 pt letter(k) title k ? "" : "difference"
    } else {
        set origin 0, 0
        set size 1, 0.36
        plot for [k = 0:curves - 1] data index k using 3:5 with points \
                 ls k % 6 + 1 title k ? "" : \
                 "difference (0: at the lower edge)", \
             for [k = 0:curves - 1] data index k using 3:6 with lines ls 8 \
                 title k ? "" : allowed
    }
}
if (!terminal) { unset multiplot }
set output
