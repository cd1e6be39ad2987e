# cost.gp - the errors of six quantities against the number of elements, and what
# an error of 1e-4 costs in each.
# Reads   data  tables errors, needed
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 720,470 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
set logscale xy
set xrange [3.3:12000]
set yrange [1e-7:0.2]
set format x "%g"
set format y "10^{%T}"
set xlabel "elements n (each: one sample of f, ten flops)"
set ylabel "error (dimensionless)"
array Of[6] = ["slope", "energy", "graded", "reaction", "L2", "nodal"]
array Name[6] = ["slope at 0: %d", "energy: %d", "energy,\ngraded: %d", \
    "reaction at 0: %d", "L²: %d", "nodes: %d"]
array Style[6] = [4, 1, 5, 6, 2, 3]
array X[6] = [1150, 1150, 1150, 90, 4.2, 3.8] # where its name stands
array Y[6] = [6e-4, 1.6e-4, 5e-5, 1.8e-5, 1.6e-4, 3.2e-5]
# of table needed, row by row; the names have them
needed(quantity) = int(system("awk -F'\t' '$1 == \"".quantity. \
    "\" && NF == 3 { print $3 }' '".data."'"))
unset key
set arrow 1 from 3.3, 1e-4 to 12000, 1e-4 nohead ls 8
set label 1 "10^{-4}" at 8000, 1.6e-4 right
do for [k = 1:6] {
    set arrow 1 + k from needed(Of[k]), 1e-4 to needed(Of[k]), 1e-7 nohead \
        ls Style[k] lw 1 dt 3
    style = Style[k]
    set label 1 + k sprintf(Name[k], needed(Of[k])) at X[k], Y[k] tc ls style
}
plot for [k = 1:6] data index "errors" using "n":Of[k] with linespoints \
         ls Style[k]
