# scramble.gp - which law brings a scrambled square back, against its error where
# nothing is wrong.
# Reads   data  table scramble (n boundary law recovered rate standard_error
#               iterations error)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,450 enhanced font "Helvetica,20" \
    background rgb "white"
set output out

stats data index "scramble" using (stringcolumn("law") eq "cubic" ? \
    column("error") : NaN) name "CUBIC" nooutput
stats data index "scramble" using (stringcolumn("law") eq "stable" ? \
    column("error") : NaN) name "STABLE" nooutput
set grid noxtics ytics back ls 9
set lmargin at screen 0.15
set rmargin at screen 0.98
set tmargin at screen 0.97
set bmargin at screen 0.265
unset key
# four bars for each law, the worse its error the further to the right
set xrange [-0.6:2.6]
set yrange [0:133]
set xtics nomirror ("extended\n0 %%" 0, sprintf("cubic\n%.2f %%%%", CUBIC_max) 1, \
    sprintf("stable\n%.1f %%%%", STABLE_max) 2)
set ytics nomirror 0,25,100
set xlabel "law; stress error at a stretch of 1.1" offset 0,-0.8
set ylabel "squares that come back (%)" offset 1
array N[4] = [4, 2, 4, 8]
array Boundary[4] = ["held", "free", "free", "free"]
array Style[4] = [3, 1, 2, 4]
array Colour[4] = ["#009E73", "#0072B2", "#D55E00", "#CC79A7"]
place(k) = (stringcolumn("law") eq "extended" ? 0 : \
    stringcolumn("law") eq "cubic" ? 1 : 2) + 0.21 * (k - 2.5)
rate(k) = column("n") == N[k] && stringcolumn("boundary") eq Boundary[k] ? \
    column("rate") : NaN
unsure(k) = column("standard_error")
# no rate is below 0 % or above 100 %
from(k) = rate(k) > unsure(k) ? rate(k) - unsure(k) : rate(k) * 0
to(k) = rate(k) + unsure(k) < 100 ? rate(k) + unsure(k) : rate(k) * 0 + 100
iterations(k) = column("recovered") > 0 ? \
    rate(k) + (rate(k) > 10 ? 6 : 9) : NaN # above the end of its error bar
set style fill solid 0.85 border
set boxwidth 0.18
set label 1 "held, n = 4" at -0.42, 125 left tc rgb Colour[1]
set label 2 "free, n = 2" at -0.19, 110 left tc rgb Colour[2]
set label 3 "free,\nn = 4" at 0.02, 68 left tc rgb Colour[3] front boxed
set label 4 "number on a bar: iterations of the\nsquares that come back (median)" at 2.58, 127 right font ",18"
set label 5 "free,\nn = 8" at 0.235, 30 left tc rgb Colour[4] front boxed
set style textbox opaque noborder margins 0.3,0.3
plot for [k = 1:4] data index "scramble" using (place(k)):(rate(k)) \
         with boxes ls Style[k], \
     for [k = 1:4] data index "scramble" using (place(k)): \
         (from(k)):(0):(to(k) - from(k)) with vectors heads \
         size graph 0.012,90 lw 1.5 lc rgb "black" notitle, \
     for [k = 1:4] data index "scramble" using (place(k)):(iterations(k)): \
         (sprintf("%.0f", column("iterations"))) with labels font ",18" \
         textcolor rgb Colour[k] notitle
set output
