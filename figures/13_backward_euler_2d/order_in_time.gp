# order_in_time.gp - the error in time over what it costs, with the measured order,
# and the error of the mesh itself, which a shorter step does not mend.
# Reads   data  tables orders_time, in_space
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,400 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
stats data index "orders_time" using "order" nooutput name "T"
stats data index "in_space" using "error" nooutput name "MESH"
stats data index "orders_time" using "systems":"error" nooutput name "LAST"
set margins screen 0.145, screen 0.975, screen 0.18, screen 0.96
unset key
set logscale xy
set format y "10^{%T}"
set xlabel "linear systems in all"
set ylabel "max |u - u_{limit}| after 0.05 s (m)"
set xrange [13:240]
set yrange [5e-4:3e-2]
set xtics (16, 24, 48, 96, 192)
set datafile missing "-"
set style textbox opaque noborder margins 0.4,0.4
set label 1 sprintf("error in time: order %.2f in Δt", T_max) at 60, 3.6e-3 \
    tc ls 1 front boxed
set label 2 "error of the mesh, n = 4" at 225, 1.3 * MESH_min right front boxed
set label 3 "dashed: slope -1" at 84, 1.5e-3 right front boxed
plot LAST_min_y * LAST_max_x / x ls 8, \
     MESH_min with lines lw 2.5 lc rgb "#999999", \
     data index "orders_time" using "systems":"error" with linespoints ls 1
