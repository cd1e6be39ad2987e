# cost.gp - the errors of six quantities against the number of elements, and what
# an error of 1e-4 costs in each.
# Reads   data  tables errors, needed
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 720,470
set output out
set logscale xy
set xrange [3.3:9000]
set yrange [1e-7:0.2]
set format x "%g"
set format y "10^{%T}"
set xlabel "elements n = samples of f = tenth of the flops"
set ylabel "error (dimensionless)"
array Of[6] = ["slope", "energy", "graded", "reaction", "L2", "nodal"]
array Name[6] = ["flux at 0 from the slope", "energy norm", \
    "energy norm, short elements at 0", "flux at 0 from the reaction", \
    "L² norm", "largest nodal error"]
array Style[6] = [4, 1, 5, 6, 2, 3]
# of table needed, row by row; the key has them
needed(quantity) = int(system("awk -F'\t' '$1 == \"".quantity. \
    "\" && NF == 3 { print $3 }' '".data."'"))
set key above left maxrows 3 samplen 2
set arrow 1 from 3.3, 1e-4 to 9000, 1e-4 nohead ls 8
set label 1 "10^{-4}" at 3.6, 1.6e-4
do for [k = 1:6] {
    set arrow 1 + k from needed(Of[k]), 1e-4 to needed(Of[k]), 1e-7 nohead \
        ls Style[k] lw 1 dt 3
}
plot for [k = 1:6] data index "errors" using "n":Of[k] with linespoints \
         ls Style[k] title sprintf("%s: %d", Name[k], needed(Of[k]))
