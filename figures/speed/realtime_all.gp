# realtime_all.gp - the worst frame of a whole swing, with and without a cap of
# systems, and the largest n that is in time, there and while the body is
# stretched.
# Reads   data  tables realtime (solver n p99_ms), swing (systems n worst_ms),
#               machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,480
set output out
of(word) = strcol("systems") eq word ? column("n") : NaN
most(word) = real(system(sprintf("awk -F'\t' '$1 == \"%s\" { print $2 }' '%s'", \
                                 word, data)))
solver(word) = strcol("solver") eq word ? column("n") : NaN
array Name[4] = ["band", "dissection", "single", "kept"]
array Text[4] = ["band", "dissection", "... in single precision", \
                 "... and kept factors"]
array Height[4] = [75, 190, 480, 1200]

set margins screen 0.12, screen 0.97, screen 0.165, screen 0.965
unset key
set label 9 machine(data) at screen 0.01,0.025 left font ",10"
set logscale xy
set xtics (16, 24, 32, 48, 64, 96, 128, 192)
set xrange [14:230]
set yrange [0.2:2e4]
set xlabel "squares per side n"
set ylabel "worst frame (ms)" offset 1
set label 1 "whole swing,\nup to 300 systems a frame" at 15,2500 tc ls 2
set label 2 "at most 8 systems a frame" at 26,5 tc ls 1
set label 3 "1/30 s" at 15,45
set label 4 sprintf("in time up to n = %.0f", most("capped_most")) \
    at 26,3.2 tc ls 1
do for [k = 1:4] {
    set label 10 + k sprintf("%s: n = %.0f", Text[k], most(Name[k])) \
        at most(Name[k]), Height[k] * 1.2 right tc ls 3
    set arrow 10 + k from most(Name[k]), 42 to most(Name[k]), Height[k] * 0.8 \
        nohead lc rgb "#009E73"
}
set label 10 "only stretched, 99 of 100 frames\nare in time up to:" \
    at 210,9000 right tc ls 3
plot data index "swing" using (of("all")):"worst_ms" with linespoints ls 2, \
     data index "swing" using (of("capped")):"worst_ms" with linespoints ls 1, \
     data index "swing" using (of("capped_most")):"worst_ms" \
         with points ls 1 pt 6 ps 1.6, \
     data index "realtime" using "n":"p99_ms" with points ls 3 ps 1.1, \
     1000.0 / 30.0 with lines ls 8
