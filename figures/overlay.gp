# overlay.gp - a student's numbers over the reference's, for make plot-NN.
#
# Given with gnuplot -e: mine, reference (data files), out (the SVG, or "" for
# the terminal), name (the table), x, y (its columns).

load "figures/style.gp"
if (out eq "") {
    set terminal dumb 78 22
    set border 3 front linetype -1
    set tics textcolor default
    unset grid
} else {
    set output out
}
set xlabel x
set ylabel y
plot reference index name using x:y with lines ls 8 title "reference", \
     mine index name using x:y with linespoints ls 1 title "mine"
set output
