# gives_up.gp - what the cubic law gives up: stress over stretch
# for small nu, which rest state Newton finds, and a bar that localises.
# Reads   data  tables stress, giveup, critical, rest_map, localised
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 940,470
set output out
set style line 5 lc rgb "#E69F00" lw 2 pt 11 ps 0.7
stats data index "critical" using "cubic_tangent" name "LIMIT" nooutput
stats data index "critical" using "cubic_rest" name "REST" nooutput
set style textbox opaque noborder margins 0.3,0.3
set multiplot
set origin 0, 0
set size 0.385, 1
set lmargin 7
set rmargin 1
set tmargin at screen 0.78
set bmargin at screen 0.12
set xlabel "stretch F"
set ylabel "stress P / E"
set xrange [-0.5:5.5]
set yrange [-5:2]
set key at graph 0, graph 1.03 left bottom maxrows 3 samplen 1.5 width -1 \
    font ",12"
set object 1 rectangle from -0.5, -5 to 0, 2 fc rgb "#EEEEEE" \
    fs solid noborder behind
set label 1 "← inverted, and" at 0.75, -4.2 font ",12"
set label 2 "    P is still defined" at 0.75, -4.55 font ",12"
plot data index "stress" using "F":"nu30" with lines ls 1 title "ν = 0.3", \
     data index "stress" using "F":"nu7" with lines ls 3 title "0.07", \
     data index "stress" using "F":"nu5" with lines ls 2 title "0.05", \
     data index "stress" using "F":"nu2" with lines ls 4 title "0.02", \
     data index "stress" using "F":"nu0" with lines ls 5 title "0", \
     data index "stress" using (column("F") > 0.05 ? column("F") : NaN):\
         "log30" with lines ls 8 title "log law, 0.3", \
     data index "giveup" using "F_limit":(column("P_limit") / 1000) \
         with points pt 6 ps 0.9 lc rgb "black" lw 1.5 title "limit load", \
     data index "giveup" using "F_rest":(0) \
         with points pt 4 ps 0.9 lc rgb "black" lw 1.5 title "second zero", \
     0 with lines ls 9 notitle
unset object 1
unset label
unset arrow
set origin 0.385, 0
set size 0.345, 1
set xlabel "start F_0 , no load"
set ylabel "Poisson's ratio ν"
set xrange [-1.1:6.1]
set yrange [-0.004:0.104]
set lmargin 10
set arrow 1 from -1.1, LIMIT_max to 6.1, LIMIT_max nohead ls 8 front
set arrow 2 from -1.1, REST_max to 6.1, REST_max nohead ls 8 front
set label 1 sprintf("limit load below %.4f", LIMIT_max) \
    at -0.9, LIMIT_max + 0.0035 font ",12" front boxed
set label 2 sprintf("two rest states below %.4f", REST_max) \
    at -0.9, REST_max + 0.0038 font ",12" front boxed
set key at graph 0, graph 1.03 left bottom maxrows 3 samplen 1 font ",12"
ends(a, b) = strcol("reason") eq "OK" && column("F") > a && \
    column("F") < b ? column("nu") : NaN
lost(reason) = strcol("reason") eq reason ? column("nu") : NaN
plot data index "rest_map" using "start":(ends(0.99, 1.01)) \
         with points pt 7 ps 0.35 lc rgb "#9CC7E6" title "ends at F = 1", \
     data index "rest_map" using "start":(ends(1.01, 9)) \
         with points pt 5 ps 0.45 lc rgb "#D55E00" \
         title "at another rest state", \
     data index "rest_map" using "start":(lost("NONFINITE")) \
         with points pt 2 ps 0.9 lw 2 lc rgb "black" \
         title "not finite: P' = 0"
unset arrow
unset label
set origin 0.73, 0
set size 0.27, 1
set xlabel "X"
set ylabel "stretch F of the elements" offset 1,0
set xrange [0:1]
set yrange [1.5:3.6]
set xtics 0.25
set lmargin 8
set key at graph 0, graph 1.03 left bottom maxrows 3 samplen 1.5 font ",12"
plot data index "localised" using "X":"nu5" with histeps ls 2 \
         title "ν = 0.05", \
     data index "localised" using "X":"nu30" with histeps ls 1 \
         title "ν = 0.3", \
     2 ls 8 title "uniform"
unset multiplot
