# map.gp - how many eigenvalues of dP/dF are negative, over the two singular
# values, both laws; lines: J = 1, and where the flip of the cubic law is 0.
# Reads   data  tables log, cubic, signs
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,480 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
zero(m) = system("awk -F'\t' '$1 == \"".m."\" && $2 == \"cubic\" { print $3 }' '".data."'") + 0.0
high = zero("flip")
set xrange [0:3]
set yrange [-1:3]
set size ratio -1
set xtics 1
set ytics 1
unset grid
unset key
set xlabel "singular value s_1"
set samples 400
set style fill solid noborder
colour(n) = n == 0 ? 0xE3EEF6 : n == 1 ? 0xF2C9A8 : 0xF0904A
# s_1 is the larger one: what lies beyond is the same state, exchanged
set object 1 polygon from 0,0 to 3,3 to 3,3.01 to 0,3.01 to 0,0 front \
    fc rgb "#EEEEEE" fs solid noborder
set object 2 polygon from 0,0 to 1,-1 to 0,-1 to 0,0 front \
    fc rgb "#EEEEEE" fs solid noborder
set label 9 "the same, exchanged" at 0.1, 2.6 left front textcolor rgb "#555555"
set multiplot layout 1,2 margins 0.125,0.985,0.18,0.92 spacing 0.09,0
set label 1 "log law" at graph 0.5, 1.05 center
set label 2 "not defined" at 1.5, -0.5 center front
set label 3 "none" at 2.2, 1.25 center front
set label 4 "one: the twist" at 0.8, 0.3 left front
set label 5 "J = 1" at 2.15, 0.64 front
set ylabel "singular value s_2" offset 1
plot data index "log" using 1:2:($1 - 0.0078):($1 + 0.0078):2:3:(colour($4)) \
         with boxxyerror lc rgb variable, \
     [0.33:3] 1 / x with lines lc rgb "black" lw 2
set label 1 "cubic law"
set label 2 "two: the twist,\na scaling" at 1.8, -0.4 center front
set label 8 "J = 1" at 2.15, 0.64 front
set label 3 "none" at 1.5, 1.0 center front
set label 4 "one: twist" at 0.85, 0.33 left front
set label 6 sprintf("J = %.2f", high) at 2.95, 1.27 right front
set label 7 "two:\nthe flip,\na scaling" at 2.95, 2.33 right front
unset ylabel
unset label 5
plot data index "cubic" using 1:2:($1 - 0.0078):($1 + 0.0078):2:3:(colour($4)) \
         with boxxyerror lc rgb variable, \
     [0.33:3] 1 / x with lines lc rgb "black" lw 2, \
     [0.75:3] high / x with lines lc rgb "black" lw 2 dt 2
unset multiplot
