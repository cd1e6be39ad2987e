# model_error.gp - how wrong linear elasticity is at a given strain and at a
# given load; 1, 5, 10 % marked for the log law.  Expected at rest: slope 0.93.
# Reads   data  tables model_error, thresholds, leading
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 740,430 enhanced font "Helvetica,15.5" \
    background rgb "white"
set output out
set style textbox opaque noborder margins 0.3,0.3

stats data index "leading" using "slope" name "SLOPE" nooutput
stats data index "leading" using "modulus" name "MODULUS" nooutput
set multiplot layout 1,2 margins 0.115,0.985,0.16,0.965 spacing 0.125,0
set yrange [0:22]
set ytics ("0" 0, "1 %%" 1, "5 %%" 5, "10 %%" 10, "20 %%" 20)
unset key

set xrange [-0.28:0.28]
set xtics ("-20 %%" -0.2, "-10 %%" -0.1, "0" 0, "10 %%" 0.1, "20 %%" 0.2)
set xlabel "strain e = F - 1"
set ylabel "relative error of the linear stress" offset 1,0
set label 3 "log" at 0.215, 15.5 left tc ls 1 boxed
set label 4 "cubic" at -0.18, 14 right tc ls 2 boxed
set label 5 sprintf("dashed: %.2f |e|", SLOPE_max) at 0, 20.9 center boxed
set label 1 "compression" at graph 0.03, graph 0.13 tc rgb "#555555" boxed
set label 2 "tension" at graph 0.97, graph 0.13 right tc rgb "#555555" boxed
plot data index "model_error" using "e":(100 * column("stress_t")) \
         with lines ls 1, \
     "" index "model_error" using (-column("e")):(100 * column("stress_c")) \
         with lines ls 1, \
     "" index "model_error" using "e":(100 * column("cubic_t")) \
         with lines ls 2, \
     "" index "model_error" using (-column("e")):(100 * column("cubic_c")) \
         with lines ls 2, \
     100 * SLOPE_max * abs(x) ls 8, \
     for [side in "t c"] data index "thresholds" every ::0::2 \
         using (column("strain_".side)):"percent" with points ls 1 ps 0.9 \
        , \
     for [k = 1:2] data index "thresholds" every ::0::2 \
         using (column(word("strain_t strain_c", k))):"percent": \
         (sprintf("%+#.3g %%", 100 * column(word("strain_t strain_c", k)))) \
         with labels left offset (k == 1 ? 0.8 : -7.5),0 boxed

set label 3 "log" at 255, 14.6 left tc ls 1 boxed
set label 4 "cubic" at -222, 13.4 right tc ls 2 boxed
set label 5 sprintf("dashed:\n%.2f |P| / (2μ + λ)", SLOPE_max) at 0, 20.9 center boxed
set xrange [-320:320]
set xtics -300,150,300
set xlabel "load P (N/m²)"
set ylabel "relative error of the linear strain" offset 1,0
plot data index "model_error" using "load_t":(100 * column("strain_t")) \
         with lines ls 1, \
     "" index "model_error" using (-column("load_c")): \
         (100 * column("strain_c")) with lines ls 1, \
     "" index "model_error" using "cubic_load_t": \
         (100 * column("cubic_strain_t")) with lines ls 2, \
     "" index "model_error" using (-column("cubic_load_c")): \
         (100 * column("cubic_strain_c")) with lines ls 2, \
     100 * SLOPE_max / MODULUS_max * abs(x) ls 8, \
     for [side in "t c"] data index "thresholds" every ::0::2 \
         using (column("load_".side)):"percent" with points ls 1 ps 0.9 \
        , \
     for [k = 1:2] data index "thresholds" every ::0::2 \
         using (column(word("load_t load_c", k))):"percent": \
         (sprintf("%+.3g", column(word("load_t load_c", k)))) \
         with labels left offset (k == 1 ? 1 : -5.2),0 boxed
unset multiplot
