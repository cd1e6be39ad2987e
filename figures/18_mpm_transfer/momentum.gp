# momentum.gp - angular momentum that seven particles lose on the way back from
# the grid, three kernels and three schemes: above without, below with a kick.
# Reads   data  table lost
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,760 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set multiplot layout 2,1 margins 0.165,0.97,0.06,0.97 spacing 0,0.09
set style data boxes
set boxwidth 0.26
set style fill solid 0.85 border
set xrange [0.4:3.6]
set yrange [-0.012:0.36]
set xtics ("linear" 1, "quadratic" 2, "cubic kernel" 3) scale 0
set ytics 0.1
unset key
set grid noxtics
set ylabel "angular momentum lost (kg m²/s)" font ",15"
set label 1 "no force: only PIC loses" at 0.5, 0.33
set label 3 "PIC" at 0.72, 0.082 center tc ls 1
set label 4 "FLIP 0" at 1.05, 0.02 center tc ls 2
set label 5 "APIC 0" at 1.34, 0.05 center tc ls 3
# rows of one scheme begin at row `first`; the bars stand beside each other
plot for [s = 1:3] data index "lost" every 3::s-1 \
         using ($0 + 1 + 0.28 * (s - 2)):"g2p" ls s
set label 1 "a rigid kick of the nodes: FLIP loses, too"
set label 3 "PIC" at 0.72, 0.174 center tc ls 1
set label 4 "FLIP" at 1.0, 0.109 center tc ls 2
set label 5 "APIC 0" at 1.32, 0.02 center tc ls 3
plot for [s = 1:3] data index "lost" every 3::s-1 \
         using ($0 + 1 + 0.28 * (s - 2)):"g2p_kicked" ls s
unset multiplot
