# maps.gp - the notes' Figure 4 through a mesh: X^2 and
# sin 2 pi X, each element coloured by the sign of its J; and the share of the
# elements that sin 2 pi X inverts, against their number.
# Reads   data  tables curve, bar, refine
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 900,430 enhanced font "Helvetica,18"
set output out

unset key
set multiplot
set tmargin at screen 0.95
set bmargin at screen 0.2

# an element as an arrow along (X, phi): its ends are on the curve
square(X) = X * X
sine(X) = sin(2 * pi * X)
rise(f, sign, want) = sign eq want ? f : NaN

set lmargin at screen 0.095
set rmargin at screen 0.335
set xrange [0:1]
set yrange [-0.05:1.02]
set xlabel "X (m)"
set ylabel "φ(X) (m)" offset 1.5
set xtics 0.5
set ytics 0.5
set label 1 "φ' = 0\nat X = 0" at 0.04, 0.42 boxed
set label 2 "φ = X^2:\nJ > 0 in every\nelement" at 0.04, 0.93 tc ls 1 boxed
set arrow 1 from 0.07, 0.28 to 0.012, 0.012 lw 1 lc rgb "black" size 0.03, 20
plot data index "curve" using "X":"square" with lines ls 8 notitle, \
     data index "bar" using "X0":(square(column("X0"))): \
         (column("X1") - column("X0")): \
         (rise(square(column("X1")) - square(column("X0")), \
               strcol("square_sign"), "upright")) \
         with vectors nohead ls 1 lw 3 notitle, \
     data index "bar" using "X0":(square(column("X0"))) with points \
         pt 7 ps 0.45 lc rgb "black" notitle, \
     data index "bar" using "X1":(square(column("X1"))) with points \
         pt 7 ps 0.45 lc rgb "black" notitle
unset arrow 1
unset label

set lmargin at screen 0.425
set rmargin at screen 0.665
set yrange [-1.1:1.1]
set ytics 0.5
set object 1 rect from 0.25, graph 0 to 0.75, graph 1 behind \
    fc rgb "#D55E00" fs transparent solid 0.10 noborder
set label 1 "φ' < 0" at 0.55, 0.87 center
set label 2 "φ = sin 2πX" at 0.015, -0.78
set label 3 "J > 0" at 0.07, 0.22 tc ls 1
set label 4 "J < 0" at 0.55, 0.1 tc ls 2
set label 5 "J = 0" at 0.25, 0.64 center tc ls 3
set label 6 "J = 0" at 0.75, -0.64 center tc ls 3
plot data index "bar" using "X0":(sine(column("X0"))): \
         (column("X1") - column("X0")): \
         (rise(sine(column("X1")) - sine(column("X0")), \
               strcol("sine_sign"), "upright")) \
         with vectors nohead ls 1 lw 3 notitle, \
     data index "bar" using "X0":(sine(column("X0"))): \
         (column("X1") - column("X0")): \
         (rise(sine(column("X1")) - sine(column("X0")), \
               strcol("sine_sign"), "inverted")) \
         with vectors nohead ls 2 lw 3 dt (6,2) notitle, \
     data index "bar" using "X0":(sine(column("X0"))): \
         (column("X1") - column("X0")): \
         (rise(sine(column("X1")) - sine(column("X0")), \
               strcol("sine_sign"), "collapsed")) \
         with vectors nohead ls 3 lw 4 dt (2,2) notitle, \
     data index "curve" using "X":"sine" with lines ls 8 notitle, \
     data index "bar" using "X0":(sine(column("X0"))) with points \
         pt 7 ps 0.45 lc rgb "black" notitle, \
     data index "bar" using "X1":(sine(column("X1"))) with points \
         pt 7 ps 0.45 lc rgb "black" notitle
unset object 1
unset label
set label 1 "n odd" at 6.8, 0.61 tc ls 4 boxed
set label 2 "n = 4k: one half" at 32, 0.685 right tc ls 1 boxed
set label 3 "n = 4k + 2:\ntwo elements\ncollapse" at 8, 0.33 tc ls 3 boxed

set lmargin at screen 0.76
set rmargin at screen 0.985
set xrange [0:33]
set yrange [0:0.72]
set xtics 8
set ytics 0.2
set xlabel "elements n of (0, 1)"
set ylabel "share of inverted elements" offset 1
only(n, want) = int(n) % 4 == want ? n : NaN
odd(n) = int(n) % 2 == 1 ? n : NaN
plot data index "refine" using (only(column("n"), 0)):"share" \
         with points ls 1 ps 0.8 notitle, \
     data index "refine" using (odd(column("n"))):"share" \
         with points ls 4 notitle, \
     data index "refine" using (only(column("n"), 2)):"share" \
         with points ls 3 notitle, \
     0.5 with lines ls 8 notitle
unset multiplot
