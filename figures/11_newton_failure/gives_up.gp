# gives_up.gp - what the cubic law gives up for a small ν: its stress has a
# largest value and may return to 0; a bar pulled to twice its length gives way
# in one element.
# Reads   data  tables stress, giveup, localised
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,410 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
# the cubic law is orange: the smaller ν, the lighter
set style line 11 lc rgb "#7A3500" lw 2
set style line 12 lc rgb "#D55E00" lw 2
set style line 13 lc rgb "#F5A25D" lw 2
set multiplot
set tmargin at screen 0.87
set bmargin at screen 0.17
unset key

set lmargin at screen 0.11
set rmargin at screen 0.49
set xlabel "stretch F"
set ylabel "stress P / E"
set xrange [0:4.5]
set xtics 1
set yrange [-1:1.4]
set label 3 "log law,\nν = 0.3" at 2.65, 0.82 tc ls 1 boxed
set label 4 "cubic law,\nν = 0.3" at 2.0, 1.25 right tc ls 11 boxed
set label 5 "ν = 0.05" at 3.4, 0.3 left tc ls 12 boxed
set label 6 "ν = 0" at 3.6, -0.6 tc ls 13 boxed
set label 7 "one element" at graph 0.5, graph 1.08 center
set label 1 "limit loads" at 1.4, 0.66 right boxed
set label 2 "no stress\nagain" at 2.8, -0.14 right boxed
plot data index "stress" using (column("F") > 0.05 ? column("F") : NaN): \
         "log30" with lines ls 1, \
     data index "stress" using "F":"nu30" with lines ls 11, \
     data index "stress" using "F":"nu5" with lines ls 12, \
     data index "stress" using "F":"nu0" with lines ls 13, \
     data index "giveup" using (column("nu") == 0 || column("nu") == 0.05 ? \
         column("F_limit") : NaN):(column("P_limit") / 1000) \
         with points pt 7 ps 0.9 lc rgb "black", \
     data index "giveup" every ::0::0 using "F_rest":(0) \
         with points pt 6 ps 1.1 lw 1.5 lc rgb "black"
unset label
set label 1 "cubic law, ν = 0.3" at 0.04, 2.1 tc ls 11 boxed
set label 3 "ten elements, pulled\nto twice the length" at graph 0.5, graph 1.12 center
set label 2 "ν = 0.05" at 0.86, 3.3 right tc ls 12 boxed

set lmargin at screen 0.68
set rmargin at screen 0.98
set xlabel "X (m)"
set ylabel "stretch F of the elements" offset 1,0
set xrange [0:1]
set yrange [1.5:3.6]
set xtics 0.5
plot data index "localised" using (column("X") - 0.05):"nu30" with steps ls 11, \
     "" index "localised" every ::9::9 using (0.9):"nu30":(0.1):(0) \
         with vectors nohead ls 11, \
     data index "localised" using (column("X") - 0.05):"nu5" with steps ls 12, \
     "" index "localised" every ::9::9 using (0.9):"nu5":(0.1):(0) \
         with vectors nohead ls 12
unset multiplot
