# filter.gp - what one transfer leaves of a wave, over its wavelength.
# Reads   data  table filter
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,430
set output out
set multiplot layout 1,2 margins 0.08,0.985,0.14,0.80 spacing 0.08,0
set logscale x
set xrange [1.9:50]
set yrange [0:1.05]
set xtics (2, 4, 8, 16, 32, 48)
set xlabel "wavelength (cells)"
set ylabel "left of the wave by one transfer"
set key above left maxrows 2 samplen 3
array Name[3] = ["linear", "quadratic", "cubic"]
do for [scheme in "pic apic"] {
    set label 1 (scheme eq "pic" ? "PIC" : "APIC") at graph 0.06, graph 0.93 \
        font ",16"
    plot for [s = 1:3] data index "filter" every ::23*(s-1)::23*s-1 \
             using "wavelength":scheme with points ls s title Name[s], \
         for [s = 1:3] data index "filter" every ::23*(s-1)::23*s-1 \
             using "wavelength":scheme."_predicted" with lines ls 8 \
             title (s == 3 ? "predicted" : "")
    unset ylabel
}
unset multiplot
