# filter.gp - what one transfer leaves of a wave, over its wavelength.
# Reads   data  table filter
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,390
set output out
set multiplot layout 1,2 margins 0.08,0.985,0.15,0.96 spacing 0.08,0
set logscale x
set xrange [1.9:50]
set yrange [0:1.05]
set xtics (2, 4, 8, 16, 32, 48)
set xlabel "wavelength (cells)"
set ylabel "left of the wave by one transfer"
unset key
set label 2 "linear kernel" at 14, 0.7 tc ls 1
set label 3 "quadratic" at 14, 0.62 tc ls 2
set label 4 "cubic" at 14, 0.54 tc ls 3
set label 5 "dashed: predicted" at 48, 0.06 right
do for [scheme in "pic apic"] {
    set label 1 (scheme eq "pic" ? "PIC" : "APIC") at graph 0.06, graph 0.93 \
        font ",16"
    plot for [s = 1:3] data index "filter" every ::23*(s-1)::23*s-1 \
             using "wavelength":scheme with points ls s, \
         for [s = 1:3] data index "filter" every ::23*(s-1)::23*s-1 \
             using "wavelength":scheme."_predicted" with lines ls 8
    unset ylabel
}
unset multiplot
