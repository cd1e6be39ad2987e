# scene.gp - what `make choose` has found: the parts of the error, and the scene.
# Reads   data  parts in index 0 (its first line: name, tolerance in per cent),
#               triangles in index 1
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,360
set output out
unset datafile columnheaders
said = system("head -n 1 '".data."' | tr -d '#'")
allowed = word(said, 2) + 0.0
stats data index 0 using 2 nooutput
set multiplot layout 1, 2 title word(said, 1) noenhanced
unset key
set xrange [0:1.3 * (STATS_max > allowed ? STATS_max : allowed)]
set yrange [6.6:-1.1]
set lmargin 11
set xlabel "error in per cent of the largest displacement"
set label 1 "allowed" at allowed, -0.75 left offset 0.4, 0
set arrow 1 from allowed, graph 0 to allowed, graph 1 nohead ls 8
plot data index 0 using ($2/2):0:($2/2):(0.35):yticlabels(1) \
    with boxxyerror fs solid 0.6 ls 1
unset label 1
unset arrow 1
set autoscale
set size ratio -1
set xlabel "X_1 (m)"
set ylabel "X_2 (m)"
set xtics autofreq font ",11" rotate by -40
set ytics autofreq font ",11"
set key below left horizontal
plot data index 1 using 1:2 with lines ls 9 title "at rest", \
    "" index 1 using 3:4 with lines ls 1 lw 0.5 title "under the load"
unset multiplot
