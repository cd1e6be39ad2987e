# printed_tangent.gp - Newton's method for the stretched square at rest, upright
# and turned by 30 degrees, with the correct tangent and with the two slips of the
# printed one.
# Reads   data  table slip_history (body slip k residual); what is below 1e-12,
#               round-off, is drawn at 1e-12
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,430 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
set multiplot layout 1,2 margins 0.145,0.985,0.165,0.89 spacing 0.105,0
unset key
set logscale y
set format y "10^{%T}"
set yrange [2e-13:1e5]
set ytics 1e-12,1e4,1e2
set ytics add ("≤10^{-12}" 1e-12)
unset mytics
set xlabel "iteration k"
set xrange [-0.3:12.3]
set xtics 4
of(body, slip) = strcol("body") eq body && strcol("slip") eq slip \
    ? (column("residual") > 1e-12 ? column("residual") : 1e-12) : NaN
array Slip[4] = ["none", "column for row", "half of mu", "both"]
set label 1 "correct tangent" at 5.2, 1.2e-11 tc ls 1 boxed
do for [body in "upright turned"] {
    left = body eq "upright"
    set title (left ? "upright" : "the same scene, turned by 30°")
    set ylabel (left ? "residual max |q_i| (N/m)" : "")
    set label 2 "column for row" at (left ? 6.6 : 5), (left ? 5e-5 : 2e3) tc ls 2 boxed
    set label 3 (left ? "half of μ\nor both" : "half of μ") \
        at 0, (left ? 2e4 : 2e3) tc ls 3 boxed
    set label 5 (left ? "" : "both; column for row\nby Cholesky: no step") \
        at 4.4, 3e-5 boxed
    set label 4 (left ? "column for row,\nby Cholesky" : "") \
        at 3.6, 2e4 tc ls 2 boxed
    plot for [i = 1:4] data index "slip_history" \
        using "k":(of(body, Slip[i])) with linespoints ls (i == 4 ? 3 : i), \
        "" index "slip_history" \
        using "k":(of(body, "column for row, Cholesky")) \
        with linespoints ls 2 dt 2
}
unset multiplot
