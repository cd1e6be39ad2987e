# quadrangles.gp - the four modes of dP/dF at a pressed state: the square as it
# is there (grey), and moved along the mode to both sides.
# Reads   data  tables stretches, factors, twist, flip, scale_low, scale_high
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,640 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
factor(m) = system("awk -F'\t' '$1 == \"".m."\" { printf \"%.0f\", $2 }' '".data."'")
stats data index "stretches" using "s1" name "ONE" nooutput
stats data index "stretches" using "s2" name "TWO" nooutput
set size ratio -1
set xrange [-0.95:0.95]
set yrange [-0.95:0.95]
unset tics
unset border
unset grid
unset key
set label 11 "■" at screen 0.24, 0.025 textcolor rgb "#CCCCCC"
set label 12 sprintf("the pressed square, s = (%.3f, %.3f)", ONE_max, TWO_max) \
    at screen 0.28, 0.025
set label 13 "along it" at -0.92, -0.87 left tc ls 1
set label 14 "against it" at 0.15, -0.87 tc ls 2
set multiplot layout 2,2 margins 0.04,0.96,0.065,0.94 spacing 0.04,0.11
do for [k = 1:4] {
    m = word("twist flip scale_low scale_high", k)
    set label 1 (k == 1 ? "twist" : k == 2 ? "flip" : \
        k == 3 ? "scaling, lower" : "scaling, higher") \
        at graph 0.5, 1.10 center font ",19"
    set label 2 factor(m)." N/m²".(factor(m) < 0 ? ", negative" : "") \
        at graph 0.5, 1.0 center
    plot data index m using "x":"y" with filledcurves closed \
             fc rgb "#DDDDDD" fs solid, \
         data index m using "x_plus":"y_plus" with lines ls 1, \
         data index m using "x_minus":"y_minus" with lines ls 2 dt (6,3)
    do for [i = 11:14] { unset label i }
}
unset multiplot
