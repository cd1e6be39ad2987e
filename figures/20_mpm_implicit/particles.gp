# particles.gp - the block that falls and turns, each of its particles as the
# parallelogram that its F makes of a square, coloured by J: the lesson's numbers.
# Reads   data  table particles (x y F11 F12 F21 F22)
# Yours   the lesson with --scene block --steps 9
# Writes  out   SVG
load "figures/style.gp"
if (!exists("reference")) reference = data
set terminal svg size 480,420
set output out
unset key
unset grid
set size ratio -1
set offsets 0.05, 0.05, 0.05, 0.05
set palette defined (0 "#0072B2", 0.5 "#BBBBBB", 1 "#D55E00")
set cbrange [0.98:1.02]
set cbtics 0.01 scale 0.3
set title "J after 0.3 s"
set xlabel "x (m)"
set ylabel "y (m)"
set xtics 0.2
set ytics 0.1
# half a side: nearly half of the way from the first particle to the second
array X[2]
stats data index "particles" using (X[$0 + 1] = column("x")) every ::0::1 nooutput
h = 0.46 * (X[2] - X[1])
h = h > 0.001 && h < 0.1 ? h : 0.02
# the corner (s, t) of the square, s and t being 1 or -1
x(s, t) = column("x") + h * (s * column("F11") + t * column("F12"))
y(s, t) = column("y") + h * (s * column("F21") + t * column("F22"))
J(k) = column("F11") * column("F22") - column("F12") * column("F21")
S(k) = k % 4 < 2 ? 1 : -1
T(k) = S(k + 1)
plot reference index "particles" using "x":"y" with points pt 7 ps 0.8 \
         lc rgb "#DDDDDD", \
     for [k = 0:3] data index "particles" using (x(S(k), T(k))):(y(S(k), T(k))): \
         (x(S(k + 1), T(k + 1)) - x(S(k), T(k))): \
         (y(S(k + 1), T(k + 1)) - y(S(k), T(k))):(J(0)) \
         with vectors nohead lw 2 lc palette, \
     data index "particles" using "x":"y":(J(0)) with points pt 7 ps 0.7 lc palette
