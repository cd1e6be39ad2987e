# spin.gp - what is left of a turning disc: its spin after each transfer, and the
# velocities of every eleventh particle at the end.
# Reads   data  tables spin (transfers ratio), disc (x y v_x v_y)
# Yours   the lesson with --disc yes
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 640,780 enhanced font "Helvetica,17" \
    background rgb "white"
set output out
unset key
set multiplot
set lmargin at screen 0.16
set rmargin at screen 0.96
set tmargin at screen 0.97
set bmargin at screen 0.60
set xlabel "transfers"
set ylabel "what is left of the spin" offset 1
set yrange [0:1.1]
plot reference index "spin" using "transfers":"ratio" with lines lw 7 \
         lc rgb "#DDDDDD", \
     data index "spin" using "transfers":"ratio" with lines ls 1
set lmargin at screen 0.13
set rmargin at screen 0.80
set tmargin at screen 0.50
set bmargin at screen 0.01
unset border
unset tics
unset grid
unset xlabel
unset ylabel
set size ratio -1
set xrange [-0.34:0.34]
set yrange [-0.34:0.34]
set palette defined (0 "#C6DBEF", 0.5 "#4292C6", 1 "#08306B")
set cbrange [0:0.3]
set colorbox user origin screen 0.83, screen 0.08 size screen 0.025, screen 0.35
set cbtics 0.1 offset -0.5 textcolor rgb "black"
set cblabel "speed (m/s)" offset -0.5
set object 1 circle at 0, 0 size 0.3 fs empty border lc rgb "#999999" lw 0.5
speed(x) = sqrt(column("v_x")**2 + column("v_y")**2)
plot data index "disc" using (column("x") - 0.09 * column("v_x")): \
         (column("y") - 0.09 * column("v_y")): \
         (0.18 * column("v_x")):(0.18 * column("v_y")):(speed(0)) \
         with vectors head size 0.016,24 nofilled lw 2 lc palette
unset multiplot
