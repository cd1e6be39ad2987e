# price.gp - by how much a block gets shorter: error of three models on finer and
# finer meshes, over the flops of their assembly and linear
# systems.
# Reads   data  table price (model n flops error)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,400 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
set logscale xy
set format x "10^{%T}"
set xrange [4e3:3e8]
set yrange [0.02:100]
set ytics ("0.03" 0.03, "0.1" 0.1, "0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30)
set xlabel "flops of assembly (with fibres) and linear systems"
set ylabel "error of the shortening (%)" offset 1
unset key
of(model, x) = strcol("model") eq model ? x : NaN
set style textbox opaque noborder margins 0.4,0.4
set label 1 "linear cord" at 3e5, 57 center front boxed
set label 2 "cubic cord" at 1.8e6, 21 center tc ls 4 front boxed
set label 3 "cubic muscle" at 3e6, 0.5 left tc ls 2 front boxed
set label 4 "4 cells" at 4e4, 1.75 center tc ls 2 front boxed
set label 5 "48 cells" at 6.5e7, 0.06 left tc ls 2 front boxed
plot data index "price" using "flops":(of("linear cord", column("error"))) \
         with linespoints ls 8 lw 1.5 pt 7 ps 0.6, \
     "" index "price" using "flops":(of("cubic cord", column("error"))) \
         with linespoints ls 4, \
     "" index "price" using "flops":(of("cubic muscle", column("error"))) \
         with linespoints ls 2
set output
