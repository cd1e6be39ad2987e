# split.gp - of what the error of a setting consists: shares of the four parts,
# with the whole error beside the bar.
# Reads   data  table split (setting error model space time solver)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,440
set output out
array Part[4] = ["model", "space", "time", "solver"]
# a part above a third has its name in the bar
array Color[4] = ["#CC79A7", "#009E73", "#F0E442", "#666666"]
sum(k) = (k > 0 ? column("model") : 0) + (k > 1 ? column("space") : 0) + \
         (k > 2 ? column("time") : 0) + (k > 3 ? column("solver") : 0)
share(k) = 100.0 * sum(k) / sum(4)
set lmargin at screen 0.515
set rmargin at screen 0.985
set tmargin at screen 0.945
set style fill solid 0.9 border lc rgb "white"
unset key
set border 0
unset grid
set yrange [9.6:-0.9]
set xrange [0:114]
set xlabel "share of the sizes of the four parts (%)"
set ytics scale 0
set xtics 0, 20, 100 nomirror
set label 1 "error" at 102, -0.75
plot for [k = 1:4] data index "split" \
         using (0):0:(share(k - 1)):(share(k)):($0 - 0.38):($0 + 0.38): \
         ytic(strcol("setting")) \
         with boxxyerror lc rgb Color[k], \
     for [k = 1:4] data index "split" using (share(k) - share(k - 1) < 33 ? NaN : \
             0.5 * (share(k - 1) + share(k))):0:(Part[k]) with labels \
         textcolor rgb (k == 4 ? "white" : "black"), \
     data index "split" using (102):0:(sprintf("%#.2g", column("error"))) \
         with labels left
