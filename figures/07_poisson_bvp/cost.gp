# cost.gp - the errors of six quantities against the number of elements, and what
# an error of 1e-4 costs in each.
# Reads   data  tables errors, needed
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,460 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
set logscale xy
set xrange [0.17:12000]
set yrange [1e-7:0.2]
set format x "%g"
set xtics 10, 10
set format y "10^{%T}"
unset mytics
set xlabel "elements n (each: one sample of β and of f, ten flops)"
set ylabel "error (dimensionless)"
array Of[6] = ["slope", "energy", "graded", "reaction", "L2", "nodal"]
array Name[6] = ["slope at 0: %d", "energy: %d", "energy, graded: %d", \
    "reaction at 0: %d", "L²: %d", "nodes: %d"]
array Style[6] = [4, 1, 5, 6, 2, 3]
# the height of its name, left of its first point
array Y[6] = [6.4e-2, 3.1e-2, 1.6e-2, 4.5e-3, 1.9e-3, 8.5e-4]
# of table needed, row by row; the names have them
needed(quantity) = int(system("awk -F'\t' '$1 == \"".quantity. \
    "\" && NF == 3 { print $3 }' '".data."'"))
unset key
set arrow 1 from 0.17, 1e-4 to 12000, 1e-4 nohead ls 8
set label 1 "10^{-4}" at 10000, 1.7e-4 right boxed
do for [k = 1:6] {
    set arrow 1 + k from needed(Of[k]), 1e-4 to needed(Of[k]), 1e-7 nohead \
        ls Style[k] lw 1 dt 3
    style = Style[k]
    set label 1 + k sprintf(Name[k], needed(Of[k])) at 3.3, Y[k] right \
        tc ls style boxed
}
# slope and energy reach 1e-4 beyond the last row of table errors
stats data index "errors" using "n":"slope" name "S" nooutput
stats data index "errors" using "n":"energy" name "E" nooutput
set arrow 9 from S_max_x, S_min_y to needed("slope"), 1e-4 nohead ls 4
set arrow 10 from E_max_x, E_min_y to needed("energy"), 1e-4 nohead ls 1
plot for [k = 1:6] data index "errors" using "n":Of[k] with linespoints \
         ls Style[k], \
     "+" using (needed("slope")):(1e-4) with points ls 4, \
     "+" using (needed("energy")):(1e-4) with points ls 1
