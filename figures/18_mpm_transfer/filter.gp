# filter.gp - what one transfer leaves of a wave, over its wavelength: PIC above,
# APIC below.
# Reads   data  table filter
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,800 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set multiplot layout 2,1 margins 0.155,0.97,0.09,0.98 spacing 0,0.05
set logscale x
set xrange [1.9:50]
set yrange [0:1.05]
set xtics (2, 4, 8, 16, 32, 48)
set ytics 0.2
set ylabel "left of the wave by one transfer" font ",15"
set format x ""
unset key
set label 4 "dashed: predicted" at 46, 0.06 right
do for [scheme in "pic apic"] {
    set label 5 (scheme eq "pic" ? "PIC" : "APIC") at 46, 0.75 right \
        font ",20"
    if (scheme eq "pic") {
        set label 1 "linear kernel" at 4.2, 0.76 right tc ls 1
        set label 2 "quadratic" at 8.2, 0.73 tc ls 2
        set label 3 "cubic" at 5.9, 0.5 tc ls 3
    } else {
        set label 4 "dashed: predicted (not for linear)"
        set format x "%g"
        set xlabel "wavelength (cells)"
        set label 1 "linear" at 2.0, 0.9 left tc ls 1
        set label 2 "quadratic" at 5.1, 0.85 tc ls 2
        set label 3 "cubic" at 3.3, 0.55 tc ls 3
    }
    plot for [s = 1:3] data index "filter" every ::23*(s-1)::23*s-1 \
             using "wavelength":scheme with points ls s, \
         for [s = 1:3] data index "filter" every ::23*(s-1)::23*s-1 \
             using "wavelength":scheme."_predicted" with lines ls 8
}
unset multiplot
