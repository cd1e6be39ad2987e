# fails.gp - which cuts under load make the next step fail: a row for each cut,
# a column for each load; systems of Newton's method with a line search, or a cross
# where K is not positive definite on its way.
# Reads   data  table fails
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,700 font "Helvetica,14"
set output out
of(how) = strcol("step") eq Step && strcol("start") eq Start && \
    (strcol("status") eq "OK") == how ? column("row") : NaN
set logscale x
set xrange [21:950]
set ytics ("halfway through" 0, "beside the held side" 1, "along slivers" 2, \
    "through, one part loose" 3, "one triangle, all around" 4, "a thousand cuts" 5)
unset mxtics
unset grid
unset key
unset colorbox
set palette defined (4 "#E8F1F8", 6 "#9CC6E3", 8 "#2F7FB5", 10 "#08306B")
set cbrange [4:10]
set lmargin at screen 0.34
set rmargin at screen 0.99
set multiplot
array Top[4] = [0.965, 0.69, 0.415, 0.265]
do for [k = 1:4] {
    Step = k < 3 ? "step" : "rest"
    Start = k % 2 ? "before" : "zero"
    set tmargin at screen Top[k]
    set bmargin at screen Top[k] - (k < 3 ? 0.23 : 0.115)
    set yrange [(k < 3 ? 5.6 : 2.6):-0.6]
    set label 1 (k < 3 ? "a step of 1/30 s, " : "at rest, ").(k % 2 ? \
        "from the state before the cut" : "from u = 0") \
        at graph 0, screen Top[k] + 0.015
    set xlabel k == 4 ? "pull at the moment of the cut (N/m)" : ""
    if (k == 4) { set xtics (25, 50, 100, 200, 400, 800) } else { set xtics ("" 25) }
    plot data index "fails" using "load":(of(1)):"systems" \
             with points pt 5 ps 1.7 lc palette, \
         "" index "fails" using "load":(of(1)):(sprintf("%d", column("systems"))): \
             (column("systems") < 8 ? 0 : 0xFFFFFF) with labels font ",12" tc rgb variable, \
         "" index "fails" using "load":(of(0)) with points pt 2 ps 0.8 lw 2 lc rgb "#D55E00"
}
unset multiplot
