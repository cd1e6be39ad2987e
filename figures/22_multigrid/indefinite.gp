# indefinite.gp - a body is pressed until K is no longer positive definite: its
# least eigenvalue, and how many iterations CG takes until it ends; crosses: it
# ends with NOT_SPD.
# Reads   data  tables squeeze, limits
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,800
set output out
set datafile missing "-"
stats data index "limits" using "squeeze" every ::0::0 nooutput name "E"
array Name[3] = ["rough", "middle", "fine"]
ends(k, word) = strcol(Name[k]) eq word ? column(Name[k]."_iterations") : NaN

set multiplot layout 2,1 margins 0.13,0.965,0.075,0.985 spacing 0,0.1
set xrange [0.56:0.68]
set xtics 0.56, 0.03, 0.68
set xlabel "squeeze of the body"
set ylabel "least eigenvalue over largest K_{ii}" offset 1
set format y "%g"
set yrange [-0.009:0.0045]
set arrow 1 from E_max,-0.009 to E_max,0.0014 nohead ls 8 lc rgb "#999999"
set arrow 2 from 0.56,0 to 0.68,0 nohead ls 8
set label 1 "positive definite" at 0.5645,0.0006
set label 2 "indefinite" at E_max+0.003,0.0009
set label 3 "here another\neigenvector takes over" at 0.5915,0.0033
set arrow 3 from 0.591,0.0029 to 0.5866,0.00185 nohead ls 8 dt 1
unset key
unset grid
plot data index "squeeze" using "squeeze":"least" with lines ls 1 lw 3
unset label 1
unset label 2
unset arrow 2
unset arrow 3
set label 4 "to 10^{-1}" at 0.5625,16.5 tc ls 1
set label 5 "to 10^{-4}" at 0.5625,43.3 tc ls 2
set label 6 "to 10^{-10}" at 0.5625,63.5 tc ls 3
set label 7 "× NOT\\_SPD; up to 0.613\nonly to 10^{-4}  or 10^{-10}" at 0.611,38
set yrange [0:70]
set ylabel "iterations of CG" offset 0
set arrow 1 from E_max,0 to E_max,70 nohead ls 8 lc rgb "#999999"
set label 3 "solved up\nto 0.613" at 0.605,12 tc ls 1
plot for [k = 1:3] data index "squeeze" using "squeeze":(ends(k, "OK")) \
         with lines ls k lw 3, \
     for [k = 1:3] "" index "squeeze" using "squeeze":(ends(k, "NOT_SPD")) \
         with points pt 2 ps 0.5 lw 1.2 lc rgb "black"
unset multiplot
