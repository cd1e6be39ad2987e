# load_map.gp - Newton's end over load and start: converged,
# by iterations, or inverted (orange); the predicted boundary p = P(F0) - F0 P'(F0).
# Reads   data  tables load_map, boundary
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,420 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set palette defined (3 "#DCEBF7", 8 "#7FB5DE", 13 "#0072B2", 18 "#003A5C")
set cbrange [2:18]
set cblabel "iterations until converged"
set xrange [-4.05:2.05]
set yrange [-1.05:5.05]
set xlabel "load p / (2μ + λ)"
unset grid
unset key
set style fill solid 1 noborder
# half a box: half the spacing of the grid, and a little overlap
stats data index "load_map" using "load":"start" name "GRID" nooutput
between = sqrt(GRID_records) - 1
w = 0.5 * (GRID_max_x - GRID_min_x) / between + 0.003
h = 0.5 * (GRID_max_y - GRID_min_y) / between + 0.003
# First and last load, start, iterations: a box where neighbours are equal.
boxes(reason) = sprintf("< awk -F'\t' 'function end(j) { if (n[j] != \"\") \
        print first[j] \"\t\" last[j] \"\t\" start[j] \"\t\" n[j] } \
    BEGIN { print \"first\tlast\tstart\titerations\" } \
    /^#/ { on = $0 == \"# load_map\" || (on && NR < 3) } \
    on && NF == 6 && $1 + 0 == $1 { \
        j = $1 == load ? j + 1 : 1; load = $1; \
        k = $%d == \"OK\" ? $(%d + 1) : \"0\"; \
        if (k != n[j]) { end(j); n[j] = k; first[j] = load } \
        last[j] = load; start[j] = $2 } \
    END { for (i = 1; i <= j; i++) end(i) }' '%s'", reason, reason, data)
set multiplot layout 1,2 margins 0.09,0.875,0.175,0.91 spacing 0.05,0
unset colorbox
set label 1 "log law" at graph 0.03, graph 1.06
set ylabel "start F_0"
set label 2 "inverted" at -3.3, 2.4 textcolor rgb "#D55E00" front
set label 3 "inverted at the start" at -3.3, -0.5 textcolor rgb "#D55E00" front
set label 4 "rest" at 0.1, 0.78 front
set object 1 circle at 0, 1 size 0.06 fc rgb "black" fs solid front
set label 5 "predicted" at -3.95, 0.9 front
plot boxes(3) using (0.5*($1 + $2)):($4 > 0 ? $3 : NaN):(0.5*($2 - $1) + w):\
         (h):($4) with boxxy palette, \
     boxes(3) using (0.5*($1 + $2)):($4 == 0 ? $3 : NaN):(0.5*($2 - $1) + w):(h) \
         with boxxy lc rgb "#FBE3CF", \
     data index "boundary" using "relative":"start" \
         with lines lc rgb "black" lw 2, \
     0 with lines lc rgb "black" lw 2
set colorbox user origin 0.895,0.175 size 0.02,0.735
set label 1 "cubic law"
unset ylabel
set format y ""
unset label 2
unset label 3
unset label 5
plot boxes(5) using (0.5*($1 + $2)):($3):(0.5*($2 - $1) + w):(h):($4) \
         with boxxy palette
unset multiplot
