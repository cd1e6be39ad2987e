# gives_up.gp - what the cubic law gives up for a small ν: its stress has a
# largest value and may return to 0; Newton's method then finds one rest state
# or the other; a bar pulled to twice its length gives way in one element.
# Reads   data  tables stress, giveup, critical, rest_map, localised
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,430
set output out
stats data index "critical" using "cubic_tangent" name "LIMIT" nooutput
stats data index "critical" using "cubic_rest" name "REST" nooutput
# the cubic law is orange: the smaller ν, the lighter
set style line 11 lc rgb "#7A3500" lw 2
set style line 12 lc rgb "#D55E00" lw 2
set style line 13 lc rgb "#F5A25D" lw 2
set multiplot
set tmargin at screen 0.80
set bmargin at screen 0.13
set key above left vertical maxrows 4 reverse Left samplen 2

set lmargin at screen 0.085
set rmargin at screen 0.365
set xlabel "stretch F"
set ylabel "stress P / E"
set xrange [0:4.5]
set yrange [-1:1.4]
set label 1 "limit loads" at 1.55, 0.64 right
set label 2 "second rest state" at 2.85, -0.13 right
plot data index "stress" using (column("F") > 0.05 ? column("F") : NaN): \
         "log30" with lines ls 1 title "log law, ν = 0.3", \
     data index "stress" using "F":"nu30" with lines ls 11 \
         title "cubic law, ν = 0.3", \
     data index "stress" using "F":"nu5" with lines ls 12 title "ν = 0.05", \
     data index "stress" using "F":"nu0" with lines ls 13 title "ν = 0", \
     data index "giveup" using (column("nu") == 0 || column("nu") == 0.05 ? \
         column("F_limit") : NaN):(column("P_limit") / 1000) \
         with points pt 7 ps 0.9 lc rgb "black" notitle, \
     data index "giveup" every ::0::0 using "F_rest":(0) \
         with points pt 6 ps 1.1 lw 1.5 lc rgb "black" notitle
unset label

set lmargin at screen 0.465
set rmargin at screen 0.725
set xlabel "start F_0, no load"
set ylabel "Poisson's ratio ν"
set xrange [-1.05:6.05]
set yrange [-0.0025:0.0975]
set xtics 2
set arrow 1 from -1.05, LIMIT_max to 6.05, LIMIT_max nohead ls 8 front
set arrow 2 from -1.05, REST_max to 6.05, REST_max nohead ls 8 front
set label 1 sprintf("limit load below %.4f", LIMIT_max) \
    at -0.9, LIMIT_max + 0.0035 front
set label 2 sprintf("two rest states below %.4f", REST_max) \
    at -0.9, REST_max + 0.0035 front
set style fill solid noborder
unset grid
plot data index "rest_map" using (strcol("reason") eq "OK" ? \
         column("start") : NaN):"nu":(0.05):(0.0025) \
         with boxxyerror fc rgb "#CFE3F0" title "ends at F = 1", \
     data index "rest_map" using (strcol("reason") eq "OK" && \
         column("F") > 1.01 ? column("start") : NaN):"nu":(0.05):(0.0025) \
         with boxxyerror fc rgb "#D55E00" title "at the other rest state", \
     data index "rest_map" using (strcol("reason") eq "NONFINITE" ? \
         column("start") : NaN):"nu" with points pt 2 ps 0.9 lw 2 \
         lc rgb "black" title "nowhere: P' = 0"
unset arrow
unset label
set grid back ls 9

set lmargin at screen 0.815
set rmargin at screen 0.99
set xlabel "X (m)"
set ylabel "stretch F of the elements" offset 1,0
set xrange [0:1]
set yrange [1.5:3.6]
set xtics 0.5
plot data index "localised" using "X":"nu30" with histeps ls 11 \
         title "cubic law, ν = 0.3", \
     data index "localised" using "X":"nu5" with histeps ls 12 \
         title "ν = 0.05"
unset multiplot
