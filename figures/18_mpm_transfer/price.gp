# price.gp - what PIC, FLIP and APIC lose of a spin and of a kick, over the flops
# of a transfer.
# Reads   data  table price
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,640
set output out
set multiplot
set lmargin at screen 0.12
set rmargin at screen 0.97
set logscale x
set xrange [8000:3e6]
set format x ""
unset key
array Open[3] = [6, 4, 8]
set tmargin at screen 0.975
set bmargin at screen 0.49
set yrange [-0.06:1.08]
set ytics 0.2
set ylabel "fraction lost in 100 transfers"
set label 1 "linear" at 2.1e5, 0.15 tc ls 1
set label 2 "quadratic" at 4.7e5, 0.215 tc ls 2
set label 3 "cubic kernel" at 8.3e5, 0.285 tc ls 3
set label 4 "PIC, 16 cells per metre" at 1.1e4, 1.04
set label 5 "32" at 4e4, 0.46 right
set label 6 "64" at 1.55e5, 0.12 right
set label 7 "APIC (and FLIP, not drawn): 0" at 1.05e4, 0.05
plot for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "pic_flops":"pic_lost" with linespoints ls s ps 0.9, \
     for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "apic_flops":"apic_lost" with points ls s \
         pt Open[s] ps 1.2
unset label
set tmargin at screen 0.455
set bmargin at screen 0.095
set format x "10^{%T}"
set xlabel "flops of a transfer, there and back"
set yrange [-0.004:0.062]
set ytics 0.02
set ylabel "fraction lost of a kick"
set label 1 "PIC" at 1e4, 0.0365
set label 2 "FLIP: dotted" at 1.15e5, 0.05
set label 3 "APIC: 0" at 1.05e4, 0.0035
plot for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "pic_flops":"kick_lost" with linespoints ls s ps 0.9, \
     for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "flip_flops":"kick_lost" with linespoints ls s dt 3 pt 2 ps 1, \
     for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "apic_flops":"apic_lost" with points ls s \
         pt Open[s] ps 1.2
unset multiplot
