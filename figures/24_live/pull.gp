# pull.gp - where a pull is lost from the last state, and why.
# Reads   data  tables limit, slope
# Writes  out   SVG
load "figures/style.gp"
per_frame = 30 * 2 * 1.28 # 30 frames per second, h = 2 / n, J = 1 + 1.28
set terminal svg size 580,740
set output out
set multiplot layout 2,1 margins 0.13,0.97,0.08,0.985 spacing 0,0.11
set key off
set style textbox opaque noborder margins 0.2, 0.2
set lmargin 9
set xlabel "squares per side n"
set ylabel "speed of the side in the hand (m/s)"
set xrange [14:66]
set yrange [1:9]
set xtics (16, 24, 32, 40, 48, 56, 64)
set label 1 "dashed: G' = μ, a jump\nof 1.28 h per frame" at 15,1.9 tc rgb "black" boxed
set label 2 "cubic law: frames are\nlost above this line" at 22.5,6.5 tc rgb "#D55E00" boxed
set label 3 "log law, n = 16 to 40: no frame is lost\nup to 7.5 m/s, the fastest hand" at 15.2,8.5 tc rgb "#0072B2" boxed
set label 4 "log law, n = 44 to 64: lost above\nthis line, because factors are kept" at 44.5,4.4 tc rgb "#0072B2" boxed
set label 5 "log law, n = 42: frames are lost\nonly at the speeds of this bar" at 43,6.15 tc rgb "#0072B2" boxed
plot per_frame / x with lines ls 8, \
     data index "limit" using "n":"cubic" with linespoints ls 2, \
     "" index "limit" using "n":(column("n") < 42 ? 7.5 : NaN) \
         with linespoints ls 1 pt 6 dt 3, \
     "" index "limit" using "n":(column("n") > 42 ? column("log") : NaN) \
         with linespoints ls 1, \
     "" index "limit" using "n":"log":(0):(column("n") == 42 ? \
         column("log_to") - column("log") : NaN) with vectors nohead ls 1 lw 6
unset label
set xlabel "J of a stretched triangle"
set ylabel "G' (N/m^2)" offset 1
set xrange [1:3]
set yrange [-500:1500]
set xtics 0.5
set label 1 "μ: above, dP/dF is not positive definite" at 1.05,560 boxed
set label 2 "cubic law" at 1.95,1150 tc rgb "#D55E00"
set label 3 "log law" at 2.5,-70 tc rgb "#0072B2"
plot data index "slope" using "J":"mu" with lines ls 8, \
     "" index "slope" using "J":"cubic" with lines ls 2, \
     "" index "slope" using "J":"log" with lines ls 1
unset multiplot
