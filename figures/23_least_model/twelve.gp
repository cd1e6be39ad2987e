# twelve.gp - the estimate of every rung of twelve ladders over its true error,
# with the band of a factor of 3; the rungs that are enough for 10 %; and the
# estimate above the buckling load, with that load and without it.
# Reads   data  tables rungs, chosen (scene model estimate error stable),
#               least (straight)
# Writes  out   SVG
if (!exists("data")) data = "build/data/23_least_model/twelve.tsv"
if (!exists("out"))  out  = "figures/23_least_model/twelve.svg"
load "figures/style.gp"
set terminal svg size 600,460
set output out
set logscale xy
set xrange [0.012:200]
set yrange [0.012:400]
set xlabel "true error of the displacement (%)"
set ylabel "estimated error (%)"
set format xy "%g"
set key at graph 0.02, graph 0.98 left top vertical maxrows 3 reverse Left samplen 2
unstable = 0
stats data index "rungs" using (strcol("stable") eq "unstable" ? unstable = column("error") : NaN) nooutput
of(r) = strcol("model") eq r && strcol("stable") eq "stable" ? column("estimate") : NaN
set style textbox opaque noborder margins 0.2, 0.2
set label 1 "3 times" at 0.125, 0.5 rotate by 38 textcolor rgb "#555555"
set label 2 "a third" at 0.40, 0.107 rotate by 38 textcolor rgb "#555555"
set label 3 "a straight column\nabove its buckling load" \
    at 180, 12 right textcolor rgb "#C00000" boxed
set label 4 "10 %" at 0.0135, 12.8 textcolor rgb "#555555"
set arrow 1 from 0.012, 10 to 200, 10 nohead ls 9
set style fill transparent solid 0.12 noborder
plot "+" using (0.012 * (200 / 0.012) ** (($0) / 99.0)):(0.012 * (200 / 0.012) ** (($0) / 99.0) / 3):(3 * 0.012 * (200 / 0.012) ** (($0) / 99.0)) \
         with filledcurves lc rgb "#0072B2" notitle, \
     x with lines ls 8 notitle, \
     data index "rungs" using "error":(of("bar")) with points ls 3 ps 1.0 title "bar", \
     "" index "rungs" using "error":(of("linear")) with points pt 13 ps 1.0 lc rgb "black" title "linear", \
     "" index "rungs" using "error":(of("cubic")) with points ls 2 ps 0.9 title "cubic", \
     "" index "rungs" using "error":(of("log")) with points ls 1 ps 0.9 notitle, \
     "" index "chosen" using "error":"estimate" with points pt 6 ps 1.7 lw 1 lc rgb "black" \
         title "enough for 10 %", \
     "" index "rungs" using "error":(strcol("stable") eq "unstable" ? column("estimate") : NaN) \
         with points pt 2 ps 2.1 lw 6 lc rgb "white" notitle, \
     "" index "rungs" using "error":(strcol("stable") eq "unstable" ? column("estimate") : NaN) \
         with points pt 2 ps 1.9 lw 2.5 lc rgb "#C00000" title "unstable", \
     "" index "least" using (unstable):"straight" \
         with points pt 4 ps 1.7 lw 2.5 lc rgb "#C00000" title "without P_{cr}"
