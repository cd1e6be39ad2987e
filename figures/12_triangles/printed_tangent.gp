# 12_backward_euler_2d_newton.gp - Newton's method in one step of a stretched
# free square, upright and turned by 30 degrees, with the right tangent and with
# the two slips of the printed one.
# Reads   data  table slip_history
# Writes  out   SVG
if (!exists("data")) data = "build/data/12_backward_euler_2d.tsv"
if (!exists("out"))  out  = "figures/12_backward_euler_2d_newton.svg"
load "figures/style.gp"
set terminal svg size 900,440
set output out
set multiplot layout 1,2 margins 0.085,0.985,0.13,0.78 spacing 0.09,0
set key above left maxrows 4 samplen 2
set logscale y
set format y "10^{%T}"
set yrange [1e-17:1e15]
set ytics 1e4
set xlabel "iteration k"
set xrange [-0.3:14.3]
set xtics 2
of(turned, slip) = column("turned") == turned && column("slip") == slip \
    ? column("residual") : NaN
array Title[4] = ["right tangent", "column for row: cof_{mj}", \
                  "half of μ", "both slips"]
do for [turned = 0:1] {
    set ylabel (turned ? "" : "residual max |q_i| (kg m)")
    set label 1 (turned ? "turned by 30°" : "upright: F starts symmetric") \
        at graph 0.97, graph 0.94 right
    plot for [slip = 0:3] data index "slip_history" \
        using "k":(of(turned, slip)) with linespoints ls slip + 1 \
        title (turned ? "" : Title[slip + 1])
}
unset multiplot
