# price.gp - left: linear systems in each step of a compression; right: distance
# to a solution after so many systems.
# Reads   data  tables steps, approach, price
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,860 enhanced font "Helvetica,19" \
    background rgb "white"
set output out
total(m) = system("awk -F'\t' '$0 == \"# price\" { on = 1 } NF == 0 { on = 0 } \
    on && $1 == \"".m."\" { print $3 }' '".data."'")
divides = system("awk -F'\t' '$0 == \"# approach\" { on = 1 } \
    NF == 0 { on = 0 } on && NF == 4 { before = last; last = $4 } \
    END { printf \"%.1f\", before / last }' '".data."'")
last = system("awk -F'\t' '$1 == \"never\" && NF > 6 { print $2 }' '".data."'") + 0
set multiplot
set tmargin at screen 0.985
set bmargin at screen 0.57
set lmargin at screen 0.18
set rmargin at screen 0.97
set logscale y
set format y "%g"
set xrange [0:60]
set yrange [2:300]
set xlabel "step"
set ylabel "linear systems in the step"
unset key
set style textbox opaque noborder margins 0.4,0.4
set label 1 "always: ".total("always")." in all" at 31, 180 tc ls 4 \
    front boxed
set label 2 "on demand: ".total("on demand")." in all" at 29.5, 8.6 tc ls 3 \
    front boxed
set label 3 "never: fails after the cross" at 1, 3.3 tc ls 2 front boxed
plot data index "steps" using "k":"always" with linespoints ls 4, \
     data index "steps" using "k":"demand" with linespoints ls 3, \
     data index "steps" using "k":"never" with linespoints ls 2 pt 4 ps 1.1 lw 1, \
     "" index "steps" using "k":(column("k") == last ? column("never") : NaN) \
         with points pt 2 ps 2 lw 3 lc rgb "#D55E00"
set tmargin at screen 0.46
set bmargin at screen 0.095
set xrange [0:12]
set yrange [1e-13:1]
set format y "10^{%T}"
set ytics 1e-16, 1e4
set xlabel "linear systems"
set ylabel "distance to the solution (m)"
unset label
set label 1 "always: each\ndivides it by ".divides at 5.7, 1.5e-3 tc ls 4 \
    front boxed
set label 2 "never, on demand:\nthe digits double" at 2.4, 3e-11 tc ls 3 \
    front boxed
plot data index "approach" using "k":"always" with linespoints ls 4, \
     data index "approach" using "k":"demand" with linespoints ls 3
unset multiplot
