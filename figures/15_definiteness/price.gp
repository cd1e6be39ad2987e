# price.gp - left: linear systems in each step of a compression; right: distance
# to a solution after so many systems.
# Reads   data  tables steps, approach, price
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,400
set output out
total(m) = system("awk -F'\t' '$0 == \"# price\" { on = 1 } NF == 0 { on = 0 } \
    on && $1 == \"".m."\" { print $3 }' '".data."'")
divides = system("awk -F'\t' '$0 == \"# approach\" { on = 1 } \
    NF == 0 { on = 0 } on && NF == 4 { before = last; last = $4 } \
    END { printf \"%.1f\", before / last }' '".data."'")
set multiplot
set tmargin at screen 0.83
set bmargin at screen 0.15
set lmargin at screen 0.08
set rmargin at screen 0.52
set logscale y
set format y "%g"
set xrange [0:60]
set yrange [3:300]
set xlabel "step"
set ylabel "linear systems in it"
set key at graph 0, 1.2 left top maxrows 3 samplen 2
plot data index "steps" using "k":"always" with linespoints ls 4 \
         title "always, ".total("always")." in all", \
     data index "steps" using "k":"demand" with linespoints ls 3 \
         title "on demand, ".total("on demand")." in all", \
     data index "steps" using "k":"never" with linespoints ls 2 \
         title "never; fails in the step after its last point"
set lmargin at screen 0.62
set rmargin at screen 0.98
set xrange [0:12]
set yrange [1e-13:1]
set format y "10^{%T}"
set ytics 1e-16, 1e4
set xlabel "linear systems"
set ylabel "distance to the solution (m)"
set key at graph 0, 1.2 left top maxrows 3 samplen 2
plot data index "approach" using "k":"always" with linespoints ls 4 \
         title "always: at last each divides it by ".divides, \
     data index "approach" using "k":"demand" with linespoints ls 3 \
         title "never, on demand: the digits double"
unset multiplot
