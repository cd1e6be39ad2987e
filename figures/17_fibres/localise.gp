# localise.gp - a strip that is pulled down the descending limb: what it would
# pull if it stayed uniform, what it pulls, where Newton's method stops; and the
# strip at 1.26 times its length, coloured by the stretch of its fibres.
# Reads   data  tables uniform, pull, strip
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,800 enhanced font "Helvetica,20" \
    background rgb "white"
set output out
set multiplot
unset key
set lmargin at screen 0.165
set rmargin at screen 0.97
set tmargin at screen 0.97
set bmargin at screen 0.49
set xlabel "length / length at rest"
set ylabel "stress on the ends (N/m^2)" offset 1
set xtics 0.1
set ytics 50
set xrange [1:1.42]
set yrange [590:860]
failed = system("awk -F'\t' '$1 == \"search\" && $7 != \"OK\" { print $2 }' '".data."'") + 0.0
on_curve = system(sprintf("awk -F'\t' '$0 == \"# uniform\" { on = 1 } NF == 0 { on = 0 } \
    on && ($1 - %f)^2 < 1e-9 { print $2 }' '%s'", failed, data)) + 0.0
by(method, x) = strcol("method") eq method ? x : NaN
set style textbox opaque noborder margins 0.4,0.4
set label 1 "if it stayed uniform" at 1.265, 780 left front boxed
set label 2 "line search: ends with NOT\\_SPD" at failed + 0.004, 808 left tc rgb "#D55E00" \
    front boxed
set label 3 "projected on demand: at each drop\nmore of the strip has left the limb" at 1.05, 640 \
    left tc rgb "#0072B2" front boxed
plot data index "uniform" using "l":"P" with lines ls 8 lw 1.5, \
     "" index "pull" using "l":(by("demand+search", column("P"))) with linespoints ls 1, \
     "" index "pull" using "l":(by("search", strcol("reason") eq "OK" ? column("P") : NaN)) \
         with points pt 6 ps 1.2 lw 1.5 lc rgb "#D55E00", \
     "+" using (failed):(on_curve) every ::0::0 with points pt 2 ps 1.6 lw 2.5 lc rgb "#D55E00"
unset label
unset border
unset tics
unset grid
unset xlabel
unset ylabel
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen 0.315
set bmargin at screen 0.145
set size ratio -1
set xrange [-1.35:1.35]
set yrange [-0.32:0.32]
set datafile nocolumnheaders
set datafile separator whitespace
triangles = sprintf("< awk -F'\t' '$0 == \"# strip\" { on = 1; next } NF == 0 { on = 0 } \
    on && $1 != \"x0\" { print $1, $2, $7; print $3, $4, $7; print \"\"; \
         print $5, $6, $7; print $5, $6, $7; print \"\"; print \"\" }' '%s'", data)
set palette defined (1.0 "#0072B2", 1.25 "#BBD6E8", 1.5 "#F2E6DA", 1.9 "#D55E00")
set cbrange [1.0:1.9]
set pm3d map corners2color c1 border lc rgb "#555555" lw 0.3
set colorbox user horizontal origin screen 0.10, screen 0.10 size screen 0.80, screen 0.022
set cbtics 0.3 scale 0.4 textcolor rgb "black"
set cblabel "stretch l of the fibres" offset 0, 0.3
longest = system("awk -F'\t' '$0 == \"# strip\" { on = 1 } NF == 0 { on = 0 } \
    on && $3 + 0 > most { most = $3 + 0 } END { print most }' '".data."'") + 0.0
set label 4 sprintf("the strip at %.2f times its length", longest) at screen 0.5, screen 0.345 center
splot triangles using 1:2:3 with pm3d
unset multiplot
