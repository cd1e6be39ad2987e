# price.gp - what PIC, FLIP and APIC lose of a spin and of a kick, over the flops
# of a transfer.
# Reads   data  table price
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,740 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set multiplot
set lmargin at screen 0.17
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
set label 1 "linear" at 2.2e5, 0.14 tc ls 1
set label 2 "quadratic" at 4.9e5, 0.16 tc ls 2
set label 3 "cubic kernel" at 8.8e5, 0.3 tc ls 3
set label 4 "PIC: full line" at 1.05e4, 1.03
set label 7 "APIC (open), as FLIP: 0" at 1.05e4, 0.06
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
set ylabel "fraction lost of a kick" offset 1
set label 1 "PIC" at 1e4, 0.037
set label 2 "FLIP: dotted" at 1.15e5, 0.05
set label 3 "APIC (open): 0" at 1.05e4, 0.0045
plot for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "pic_flops":"kick_lost" with linespoints ls s ps 0.9, \
     for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "flip_flops":"kick_lost" with linespoints ls s dt 3 pt 2 ps 1, \
     for [s = 1:3] data index "price" every ::3*(s-1)::3*s-1 \
         using "apic_flops":"apic_lost" with points ls s \
         pt Open[s] ps 1.2
unset multiplot
