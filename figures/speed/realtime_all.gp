# realtime_all.gp - the longest step of a whole swing, with and without a cap of
# systems, and the largest n that is in time, there and while the body is
# stretched.
# Reads   data  tables realtime (solver n p99_ms), swing (systems n worst_ms),
#               machine; from `make bench`
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,700
set output out
of(word) = strcol("systems") eq word ? column("n") : NaN
most(word) = real(system(sprintf("awk -F'\t' '$1 == \"%s\" { print $2 }' '%s'", \
                                 word, data)))
solver(word) = strcol("solver") eq word ? column("n") : NaN
array Name[4] = ["band", "dissection", "single", "kept"]

set multiplot
set lmargin at screen 0.13
set rmargin at screen 0.97
set tmargin at screen 0.975
set bmargin at screen 0.46
unset key
set label 9 machine(data) at screen 0.01,0.018 left textcolor rgb "#555555"
set logscale xy
set xtics (16, 24, 32, 48, 64)
set xrange [14:74]
set yrange [0.1:1e4]
set ytics 0.1, 10, 1e4
set xlabel "squares per side n"
set ylabel "longest step of the swing (ms)" offset 1
set grid noxtics
set label 1 "at most 300\nsystems per step" at 26,500 tc ls 2
set label 2 sprintf("at most 8 systems per step,\nall in time up to n = %.0f", \
    most("capped_most")) at 29,5 tc ls 1
set label 3 "1/30 s" at 15,55
plot data index "swing" using (of("all")):"worst_ms" with linespoints ls 2, \
     data index "swing" using (of("capped")):"worst_ms" with linespoints ls 1, \
     data index "swing" using (of("capped_most")):"worst_ms" \
         with points ls 1 pt 6 ps 1.6, \
     1000.0 / 30.0 with lines ls 8
unset label
unset logscale
set tmargin at screen 0.34
set bmargin at screen 0.125
set lmargin at screen 0.36
set xrange [0:1.2 * most("kept")]
set yrange [4.6:0.4]
set xtics autofreq
set ytics ("band (90 to 100)" 1, "dissection (124 to 148)" 2, \
    "dissection, single\n(128 to 160)" 3, \
    "dissection, single,\nkept (146 to 172)" 4) scale 0
unset grid
unset ylabel
set xlabel "largest n with at most one of 90 steps late (brackets: ten runs)"
set style fill solid 0.9 noborder
do for [k = 1:4] {
    set label k sprintf("%.0f", most(Name[k])) at most(Name[k]), k offset 0.6,0
}
plot for [k = 1:4] "+" using (0):(k):(0):(most(Name[k])):(k - 0.33):(k + 0.33) \
         every ::0::0 with boxxyerror lc rgb "#009E73"
unset multiplot
