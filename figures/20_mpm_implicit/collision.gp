# collision.gp - two discs that meet: as particles on one grid they bounce (left),
# as triangles they pass through each other (right).
# Reads   data  tables particles, triangles, outcome
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,800 enhanced font "Helvetica,17" \
    background rgb "white"
set output out
array Time[3] = [0.02, 0.07, 0.13]
blue = "#0072B2"
orange = "#D55E00"
h = 0.0625
unset key
unset tics
unset border
unset grid
set size ratio -1
set xrange [-0.7:0.7]
set yrange [-0.46:0.46]
row(side, when) = column("h") == h && column("when") == when && \
    strcol("disc") eq side
outcome(method, column) = system(sprintf("awk -F'\t' '$1 == \"%s\" && \
    $2 == %g { print $%d; exit }' '%s'", method, h, column, data)) + 0.0
set style fill transparent solid 0.5 noborder

set multiplot
do for [k = 1:3] {
    set lmargin at screen 0.01
    set rmargin at screen 0.49
    set tmargin at screen 0.93 - 0.325*(k - 1)
    set bmargin at screen 0.93 - 0.325*(k - 1) - 0.276
    set label 1 sprintf("%.2f s", Time[k]) at graph 1.02,1.06 center
    set label 2 k == 1 ? "particles on one grid" : k == 3 ? \
        sprintf("blue: %.1f m/s to the left", abs(outcome("particles", 4))) : \
        sprintf("at closest %.2f cells", outcome("particles", 3)) \
        at graph 0.45,1.06 center front
    # the lines of the grid
    do for [i = -10:10] {
        set arrow 100 + i from i*h, -0.46 to i*h, 0.46 nohead \
            lw 0.4 lc rgb "#CCCCCC" back
    }
    do for [j = -7:7] {
        set arrow 200 + j from -0.66, j*h to 0.66, j*h nohead \
            lw 0.4 lc rgb "#CCCCCC" back
    }
    plot data index "particles" using (row("left", k - 1) ? column("x") : 1/0):"y" \
             with points pt 7 ps 0.35 lc rgb blue, \
         "" index "particles" using (row("right", k - 1) ? column("x") : 1/0):"y" \
             with points pt 7 ps 0.35 lc rgb orange
    unset arrow
    set lmargin at screen 0.51
    set rmargin at screen 0.99
    unset label 1
    set label 2 k == 1 ? "triangles" : k == 3 ? \
        sprintf("%.0f %% overlap", 100 * outcome("mesh", 6)) : "no force" \
        at graph 0.55,1.06 center front
    go = 3 * Time[k]
    edges(side) = "< awk -F'\t' '$1 == \"".side."\" && NF == 7 { print $2, $3; print $4, $5; print $6, $7; \
        print $2, $3; print \"\" }' '".data."'"
    # the cells of a row, as one rectangle of height h
    rows(side) = "< awk -F'\t' 'function end() { if (y != \"\") \
        print low, y \"\\n\" high, y \"\\n\" high, y + h \"\\n\" low, y + h \"\\n\" } \
        BEGIN { h = 0.0625; y = \"\" } $1 == \"".side."\" && NF == 7 { \
        if ($3 != y) { end(); y = $3; low = high = $2 } \
        for (i = 2; i <= 6; i += 2) { \
            if ($i < low) low = $i; if ($i > high) high = $i } } \
        END { end() }' '".data."'"
    set datafile nocolumnheaders
    set datafile separator whitespace
    plot rows("left") using ($1 + go):2 with filledcurves closed fc rgb blue, \
         rows("right") using ($1 - go):2 with filledcurves closed fc rgb orange, \
         edges("left") using ($1 + go):2 with lines lw 0.6 lc rgb "#444444", \
         edges("right") using ($1 - go):2 with lines lw 0.6 lc rgb "#444444"
    set datafile columnheaders
    set datafile separator "\t"
}
unset multiplot
