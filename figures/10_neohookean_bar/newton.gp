# newton.gp - what Newton sees and what it does, step by
# step, and the law of its error.  Expected: slope 2 with the constant
# |P''/2P'| of the element with the largest error.
# Reads   data  table newton
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,410 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3

stats data index "newton" using "k":"predicted" name "P" nooutput
stats data index "newton" using "k":"residual" name "R" nooutput
C = P_max_y
stats data index "newton" every ::0::0 using "residual" name "Q" nooutput
stats data index "newton" every ::0::0 using "error" name "E" nooutput
stats data index "newton" every ::1::1 using "increment" name "D" nooutput
# over its first value, and only what is there before round-off: an error
# above 1e-10
clean(name, first) = column("error") > 1e-10 ? column(name) / first : NaN
set multiplot layout 1,2 margins 0.12,0.975,0.17,0.965 spacing 0.13,0
unset key
set label 1 "residual max |q_i|" at 1.3, 9 tc ls 1 boxed
set label 2 "increment\nmax |Δu_i|" at 4.3, 1e-1 tc ls 3 boxed
set label 3 "largest error of F" at 4.15, 1.5e-5 right tc ls 2 boxed
set logscale y
set format y "10^{%T}"
set yrange [1e-9:30]
set ytics 1e-8,1e2
set xlabel "step k"
set ylabel "size over its first value" offset 0.5,0
set xrange [-0.3:R_max_x + 0.3]
set xtics 1
plot data index "newton" using "k":(clean("residual", Q_max)) \
         with linespoints ls 1, \
     "" index "newton" using "k":(column("increment") / D_max) \
         with linespoints ls 3, \
     "" index "newton" using "k":(clean("error", E_max)) \
         with linespoints ls 2

unset label
set label 1 sprintf("dashed, expected:\n%.3f (error before)²", C) at 1.5e-5, 1e-1 boxed
set label 2 "Newton, from\nright to left" at 3e-3, 1e-6 tc ls 2 boxed
set logscale xy
set format x "10^{%T}"
set xrange [1e-5:1]
set xtics 100
set yrange [1e-9:2]
set ytics 1e-8,100
unset mytics
unset mxtics
set xlabel "error before the step"
set ylabel "error after the step"
prev = NaN
plot C * x**2 ls 8, \
     data index "newton" using (p = prev, p):(prev = column("error"), \
         prev > 1e-10 ? prev : 1/0) \
         with linespoints ls 2
unset multiplot
