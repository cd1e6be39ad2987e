# weight.gp - bars under their own weight: where the free end goes, and the
# error of linear elements over h^2, which is a constant known beforehand,
# c/24 (1/P'(1) - 1/P'(F_c)).
# Reads   data  tables weight, weight_curve, order
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,410 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
# The entry of a column in row r = 0, 1, ... of a table.
cell(table, name, r) = system(sprintf( \
    "awk -F'\t' -v t='# %s' -v c='%s' -v r=%d \
     '$0 == t { on = 1; next } /^# / { next } \
      on == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i; on = 2; next } \
      on == 2 && r-- == 0 { print $k; exit }' '%s'", \
    table, name, r, data)) + 0.0

set multiplot layout 1,2 margins 0.115,0.985,0.17,0.965 spacing 0.145,0
unset key

set xlabel "body force c (N/m³)"
set ylabel "displacement u(1) of the free end (m)" offset 1,0
set xrange [-4200:3800]
set yrange [-1.6:1.8]
set xtics 2000
set label 1 "standing" at -2000,-1.4 center boxed
set label 2 "hanging" at 1900,-1.4 center boxed
set label 3 "log: Newton from rest\ninverts at -4000" at -4050,0.9 tc ls 1 boxed
set label 4 "log" at 2130, 1.63 tc ls 1
set label 5 "cubic" at 2150, 0.94 tc ls 2
set label 6 "linear" at 2150, 0.7
set label 7 "lines: closed forms;\npoints: 16 elements" at 3600, -0.65 right boxed
plot data index "weight_curve" using "c":"log" with lines ls 1, \
     "" index "weight" using "c":"log_u1" with points ls 1 ps 0.8, \
     data index "weight_curve" using "c":"cubic" with lines ls 2, \
     "" index "weight" using "c":"cubic_u1" with points ls 2 ps 0.8, \
     data index "weight_curve" using "c":"linear" with lines ls 8
unset label

set logscale x
set xrange [3e-3:0.36]
set yrange [0:0.018]
set ytics 0.005
set xtics ("1/256" 1./256, "1/64" 1./64, "1/16" 1./16, "1/4" 1./4)
set xlabel "element length h (m)"
set ylabel "|error| of u(1) over h² (1/m)" offset 1,0
set label 1 "hanging, c = 500 N/m³" at 0.0042, 0.0160 boxed
set label 2 "standing, c = -500 N/m³" at 0.0042, 0.0086 boxed
set label 3 sprintf("log: order %.2f", cell("order", "order", 6)) \
    at 0.0042, 0.0028 tc ls 1 boxed
set label 4 sprintf("cubic: order %.2f", cell("order", "order", 13)) \
    at 0.0042, 0.0018 tc ls 2 boxed
set label 5 "dashed: predicted constants" at 0.0042, 0.0008 boxed
predicted(s) = abs(cell("order", "predicted", 7 * (s - 1)))
plot for [s = 1:4] data index "order" every ::7*(s - 1)::7*s - 1 \
         using "h":(abs(column("constant"))) \
         with points ls (s - 1) % 2 + 1 ps 0.9, \
     for [s = 1:4] predicted(s) ls 8
unset multiplot
