# momentum.gp - angular momentum that seven particles lose on the way to the grid
# and on the way back, three kernels and three schemes.
# Reads   data  table lost
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,380
set output out
set multiplot layout 1,2 margins 0.08,0.985,0.10,0.96 spacing 0.09,0
set style data boxes
set boxwidth 0.26
set style fill solid 0.85 border
set xrange [0.4:3.6]
set yrange [-0.012:0.34]
set xtics ("linear" 1, "quadratic" 2, "cubic" 3) scale 0
unset key
set label 3 "PIC" at 0.72, 0.078 center tc ls 1
set label 4 "FLIP: 0" at 0.88, 0.012 left tc ls 2 font ",11"
set label 5 "APIC: 0" at 1.16, 0.032 left tc ls 3 font ",11"
set ylabel "angular momentum lost (kg m²/s)" offset 0.5
set label 1 "nothing happens between" at graph 0.03, graph 0.95
set label 2 "lost on the way back; on the way to the grid\nno scheme loses any" \
    at graph 0.03, graph 0.83 font ",12"
# rows of one scheme begin at row `first`; the bars stand beside each other
plot for [s = 1:3] data index "lost" every 3::s-1 \
         using ($0 + 1 + 0.28 * (s - 2)):"g2p" ls s
set label 3 "PIC" at 0.72, 0.168 center tc ls 1
set label 4 "FLIP" at 1.0, 0.103 center tc ls 2 font ",12"
set label 2 "APIC: nothing either way"
set label 1 "the nodes get a rigid kick"
unset ylabel
plot for [s = 1:3] data index "lost" every 3::s-1 \
         using ($0 + 1 + 0.28 * (s - 2)):"g2p_kicked" ls s
unset multiplot
