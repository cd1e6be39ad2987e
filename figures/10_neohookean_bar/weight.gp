# weight.gp - bars under their own weight: where the free
# end goes, and the error of linear elements against their length.
# Expected: slope 2, constants c/24 (1/P'(1) - 1/P'(F_c)).
# Reads   data  tables weight, weight_curve, order
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 860,440
set output out
# The entry of a column in row r = 0, 1, ... of a table.
cell(table, name, r) = system(sprintf( \
    "awk -F'\t' -v t='# %s' -v c='%s' -v r=%d \
     '$0 == t { on = 1; next } /^# / { next } \
      on == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i; on = 2; next } \
      on == 2 && r-- == 0 { print $k; exit }' '%s'", \
    table, name, r, data)) + 0.0

set multiplot layout 1,2 margins 0.085,0.985,0.125,0.77 spacing 0.11,0
set key above left vertical maxrows 5 reverse Left samplen 2 font ",12"

set xlabel "body force c (N/m)"
set ylabel "displacement u(1) of the free end (m)"
set xrange [-4200:2200]
set yrange [-1.6:1.8]
set xtics 1000
set label 1 "standing" at -3900,1.55 font ",12"
set label 2 "hanging" at 250,-1.35 font ",12"
plot data index "weight_curve" using "c":"linear" with lines ls 8 dt 3 \
         title "linear bar", \
     "" index "weight_curve" using "c":"cubic" with lines ls 8 \
         title "closed form", \
     "" index "weight_curve" using "c":"log" with lines ls 8 notitle, \
     "" index "weight" using "c":"cubic_u1" with points ls 1 ps 0.8 \
         title "cubic, 16 elements", \
     "" index "weight" using "c":"log_u1" with points ls 2 ps 0.7 \
         title "log, 16 elements (c = -4000: inverted)"
unset label

set logscale xy
set format y "10^{%T}"
set xrange [3e-3:0.36]
set xtics ("1/256" 1./256, "1/64" 1./64, "1/16" 1./16, "1/4" 1./4)
set xlabel "element length h (m)"
set ylabel "|error| of u(1) (m)"
set yrange [3e-8:1e-2]
array Row[4] = [0, 7, 14, 21]
array Name[4] = ["log, hanging", "cubic, hanging", "log, standing", \
                 "cubic, standing"]
array Style[4] = [2, 1, 4, 3]
plot for [s = 1:4] data index "order" every ::Row[s]::Row[s] + 6 \
         using "h":(abs(column("error"))) with linespoints ls Style[s] \
         title sprintf("%s: order %.2f", Name[s], \
                       cell("order", "order", Row[s] + 6)), \
     abs(cell("order", "predicted", 0)) * x**2 ls 8 title "slope 2, constant predicted", \
     for [s = 2:4] abs(cell("order", "predicted", Row[s])) * x**2 ls 8 notitle
unset multiplot
