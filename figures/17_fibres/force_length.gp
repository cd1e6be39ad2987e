# force_length.gp - the length to which a free strip contracts, by four models,
# and where each is 1 % off the fullest.
# Reads   data  tables length, least
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 700,430 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
unset key
set rmargin at screen 0.76
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
    set label i sprintf("1 %% off at %.2f", limit(Row[i])) \
        at limit(Row[i]) + 0.02, height(Row[i]) + 0.012 left \
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
set output
