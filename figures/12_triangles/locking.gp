# locking.gp - linear elasticity on triangles: how much too small the
# displacement of the free end is, against n, for three Poisson ratios.
# Reads   data  table locking
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,420 enhanced font "Helvetica,14" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3
set rmargin 17
# the slope of the last segment
order(column) = system("awk -F'\t' '$0 == \"# locking\" { on = 1 } \
    NF == 0 { on = 0 } on { a = b; b = $".column." } \
    END { printf \"%.2f\", log(a / b) / log(2) }' '".data."'")
set logscale xy
set xrange [3.5:75]
set yrange [1e-3:0.6]
set xtics (4, 8, 16, 32, 64)
set format y "%g"
set xlabel "squares per side n"
set ylabel "missing displacement, 1 - u / reference"
unset key
set label 1 "ν = 0.4999:\nlast slope ".order(7) at 70, 0.25 tc ls 2
set label 2 "ν = 0.49:\nlast slope ".order(6) at 70, 0.028 tc ls 3
set label 3 "ν = 0.3:\nlast slope ".order(5) at 70, 0.003 tc ls 1
set label 4 "slope 1.42, of\nthe corners" at 14, 0.007 right boxed
plot data index "locking" using "n":"error_0.4999" with linespoints ls 2, \
     data index "locking" using "n":"error_0.49" with linespoints ls 3, \
     data index "locking" using "n":"error_0.3" with linespoints ls 1, \
     [8:64] 0.55 / x**1.42 with lines ls 8
