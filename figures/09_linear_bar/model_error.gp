# model_error.gp - how wrong linear elasticity is at a given strain and at a
# given load; 1, 5, 10 % marked.  Expected slope 1.
# Reads   data  tables model_error, thresholds, leading
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,430 enhanced font "Helvetica,13" \
    background rgb "white"
set output out

stats data index "leading" using "slope" name "SLOPE" nooutput
stats data index "leading" using "modulus" name "MODULUS" nooutput
set multiplot layout 1,2 margins 0.085,0.985,0.135,0.78 spacing 0.105,0
set logscale xy
set yrange [5e-4:2]
set ytics ("0.1 %%" 1e-3, "1 %%" 1e-2, "5 %%" 5e-2, "10 %%" 0.1, "100 %%" 1)
set format y "%g"
set key above left vertical maxrows 4 reverse Left samplen 2 width -2

set xrange [8e-4:0.6]
set xtics ("0.001" 1e-3, "0.01" 1e-2, "0.1" 0.1, "0.5" 0.5)
set xlabel "strain |e|, e = F - 1"
set ylabel "relative error of the linear stress" offset 1
plot data index "model_error" using "e":"stress_t" with lines ls 1 \
         title "log law, tension", \
     data index "model_error" using "e":"stress_c" with lines ls 2 \
         title "log law, compression", \
     data index "model_error" using "e":"cubic_t" with lines ls 3 dt 4 \
         title "cubic law, tension", \
     data index "model_error" using "e":"cubic_c" with lines ls 4 dt 4 \
         title "cubic law, compression", \
     data index "thresholds" every ::0::2 \
         using "strain_t":(0.01*column("percent")) \
         with points ls 1 ps 1 title "1, 5, 10 %", \
     data index "thresholds" every ::0::2 \
         using (-column("strain_c")):(0.01*column("percent")) \
         with points ls 2 ps 0.8 notitle, \
     data index "thresholds" every ::0::2 \
         using "strain_t":(0.01*column("percent")): \
         (sprintf("%#.3g %% or -%#.3g %%", 100*column("strain_t"), \
          -100*column("strain_c"))) \
         with labels right offset -1,0.4 font ",11" notitle, \
     SLOPE_max * x ls 8 title sprintf("%.2f |e|, slope 1", SLOPE_max)

set xrange [1:2000]
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1000)
set xlabel "load |P| (N/m²); E = 1000, ν = 0.3"
set ylabel "relative error of the linear strain" offset 1
set format y "%g"
plot data index "model_error" using "load_t":"strain_t" with lines ls 1 \
         title "log law, tension", \
     data index "model_error" using "load_c":"strain_c" with lines ls 2 \
         title "log law, compression", \
     data index "thresholds" every ::0::2 \
         using "load_t":(0.01*column("percent")) \
         with points ls 1 ps 1 title "1, 5, 10 %", \
     data index "thresholds" every ::0::2 \
         using (-column("load_c")):(0.01*column("percent")) \
         with points ls 2 ps 0.8 notitle, \
     data index "thresholds" every ::0::2 \
         using "load_t":(0.01*column("percent")): \
         (sprintf("%.3g or -%.3g", column("load_t"), -column("load_c"))) \
         with labels right offset -1,0.4 font ",11" notitle, \
     SLOPE_max * x / MODULUS_max ls 8 \
     title sprintf("%.2f |P| / (2μ+λ), slope 1", SLOPE_max)
unset multiplot
set output
