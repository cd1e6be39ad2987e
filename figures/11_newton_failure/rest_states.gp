# rest_states.gp - where Newton's method without load ends, over its start and
# over ν: the cubic law has a second state of rest for a small ν.
# Reads   data  tables critical, rest_map
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 480,430
set output out
stats data index "critical" using "cubic_tangent" name "LIMIT" nooutput
stats data index "critical" using "cubic_rest" name "REST" nooutput
unset key
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
set label 3 "ends at F = 1" at 2.5, 0.05 center front
set label 4 "ends at the other rest state" at 4.1, 0.0251 center front \
    tc rgb "white"
set label 5 "nowhere:\nP' = 0" at 1.75, 0.0065 right front
unset grid
plot data index "rest_map" using (strcol("reason") eq "OK" ? \
         column("start") : NaN):"nu":(0.05):(0.0025) \
         with boxxyerror fc rgb "#CFE3F0" , \
     data index "rest_map" using (strcol("reason") eq "OK" && \
         column("F") > 1.01 ? column("start") : NaN):"nu":(0.05):(0.0025) \
         with boxxyerror fc rgb "#D55E00" , \
     data index "rest_map" using (strcol("reason") eq "NONFINITE" ? \
         column("start") : NaN):"nu" with points pt 2 ps 0.9 lw 2 \
         lc rgb "black"
