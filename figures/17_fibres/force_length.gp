# force_length.gp - the force-length curve of a muscle with its limbs, and the
# length to which a free strip contracts, by four models.
# Reads   data  tables curve, length, least
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 960,400
set output out
set multiplot layout 1,2 margins 0.07,0.87,0.14,0.95 spacing 0.10,0
unset key
set xlabel "stretch l of the fibre"
set ylabel "tension T (N/m^2)" offset 1
set xrange [0.4:1.7]
set yrange [0:345]
set xtics 0.2
set arrow 1 from 1, 0 to 1, 322 nohead ls 9 lw 1
set arrow 2 from 0.5, 0 to 0.5, 322 nohead ls 9 lw 1
set arrow 3 from 1.5, 0 to 1.5, 322 nohead ls 9 lw 1
set label 1 "ascending limb" at 0.75, 332 center
set label 2 "descending limb" at 1.25, 332 center
set label 3 "T' > 0" at 0.75, 312 center font ",11"
set label 4 "active: T' < 0" at 1.25, 312 center font ",11"
set label 5 "active" at 0.63, 90 tc rgb "#0072B2"
set label 6 "passive" at 1.22, 28 center tc rgb "#009E73"
set label 7 "both" at 1.335, 215 left tc rgb "#D55E00"
plot data index "curve" using "l":"passive" with lines ls 3 lw 2.5, \
     "" index "curve" using "l":"T" with lines ls 2 lw 2.5, \
     "" index "curve" using "l":"active" with lines ls 1 lw 2.5 dt 2
unset for [i = 1:3] arrow i
unset for [i = 1:7] label i
limit(row) = system("awk -F'\t' '$0 == \"# least\" { on = 1 } NF == 0 { on = 0 } \
    on && $1 == \"".row."\" { print $2 }' '".data."'") + 0.0
height(row) = system("awk -F'\t' '$0 == \"# least\" { on = 1 } NF == 0 { on = 0 } \
    on && $1 == \"".row."\" { print $3 }' '".data."'") + 0.0
set xlabel "activation"
set ylabel "length of the free strip / length at rest" offset 1
set xrange [0:1]
set yrange [0.71:1.005]
set ytics 0.05
array Row[3] = ["linear cord", "linear muscle", "cubic cord"]
array Says[3] = ["linear, cord", "linear, muscle", "cubic law, cord"]
array Colour[3] = ["#000000", "#0072B2", "#CC79A7"]
do for [i = 1:3] {
    set object i circle at limit(Row[i]), height(Row[i]) size 0.009 \
        fc rgb Colour[i] fs solid noborder front
    set label i sprintf("%s: 1 %% off at %.2f", Says[i], limit(Row[i])) \
        at limit(Row[i]) + 0.02, height(Row[i]) + 0.012 left font ",11" \
        tc rgb Colour[i]
}
set label 11 "cubic law, muscle" at 1.03, 0.807 tc ls 2
set label 12 "cubic law, cord" at 1.03, 0.790 tc ls 4
set label 13 "linear, muscle" at 1.03, 0.769 tc ls 1
set label 14 "linear, cord" at 1.03, 0.727
plot data index "length" using "activation":"cubic_muscle" with lines ls 2, \
     "" index "length" using "activation":"cubic_cord" with lines ls 4 dt 4, \
     "" index "length" using "activation":"linear_muscle" with lines ls 1, \
     "" index "length" using "activation":"linear_cord" with lines ls 8 lw 1.5 dt 4
unset multiplot
