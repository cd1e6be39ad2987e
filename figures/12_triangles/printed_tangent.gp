# printed_tangent.gp - Newton's method in one step of a stretched free square,
# upright and turned by 30 degrees, with the right tangent and with the two
# slips of the printed one.
# Reads   data  table slip_history (body slip k residual); what is below 1e-12,
#               round-off, is drawn at 1e-12
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,440
set output out
set multiplot layout 1,2 margins 0.085,0.985,0.13,0.78 spacing 0.09,0
set key above left maxrows 4 samplen 2
set logscale y
set format y "10^{%T}"
set yrange [1e-13:1e15]
set ytics 1e4
set xlabel "iteration k"
set xrange [-0.3:12.3]
set xtics 2
of(body, slip) = strcol("body") eq body && strcol("slip") eq slip \
    ? (column("residual") > 1e-12 ? column("residual") : 1e-12) : NaN
array Slip[4] = ["none", "column for row", "half of mu", "both"]
array Title[4] = ["right tangent", "column for row: cof_{mj}", \
                  "half of μ", "both slips"]
do for [body in "upright turned"] {
    left = body eq "upright"
    set ylabel (left ? "residual max |q_i| (kg m)" : "")
    set label 1 (left ? "upright: F starts symmetric" : "turned by 30°") \
        at graph 0.97, graph 0.94 right
    plot for [i = 1:4] data index "slip_history" \
        using "k":(of(body, Slip[i])) with linespoints ls i \
        title (left ? Title[i] : "")
}
unset multiplot
