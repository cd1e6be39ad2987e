# roundoff.gp - the error of u against the flops of the factorisation, in single
# and in double precision, beside that of exact arithmetic.
# Reads   data  table roundoff
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 640,420 enhanced font "Helvetica,14"
set output out
set logscale xy
set xrange [6:1e7]
set yrange [1e-12:3]
set format xy "10^{%T}"
set xlabel "flops of the factorisation"
set ylabel "largest error of u, relative"
unset key
set label 1 "single precision" at 2e4, 1e-3 left textcolor ls 2 boxed
set label 2 "double precision" at 7e4, 4e-10 right textcolor ls 1 boxed
set label 3 "dashed: exact arithmetic,\na quarter for twice the flops" \
    at 10, 1e-10 left boxed
plot data index "roundoff" using "flops":"exact" with lines ls 8, \
     "" index "roundoff" using "flops":"single" with linespoints ls 2, \
     "" index "roundoff" using "flops":"double" with linespoints ls 1
