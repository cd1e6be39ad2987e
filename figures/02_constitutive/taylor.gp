# taylor.gp - Taylor remainders of the energy against the step,
# for the right law, a wrong stress, a wrong tangent.
# Expected slopes: 2 and 3; 1 and 1; 2 and 2.
# Reads   data  tables taylor, taylor_slopes
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 860,440 enhanced font "Helvetica,18"
set output out

slope(name) = real(system(sprintf( \
    "awk -F'\t' -v c='%s' '$0 == \"# taylor_slopes\" { on = 1; next } \
     on == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i; on = 2; next } \
     on == 2 { print $k; exit }' '%s'", name, data)))

set logscale xy
set format x "2^{%L}"
set xtics ("2^{-10}" 2**-10, "2^{-8}" 2**-8, "2^{-6}" 2**-6, "2^{-4}" 2**-4, \
           "2^{-2}" 2**-2)
set xrange [7e-4:0.35]
set yrange [1e-7:1e3]
set xlabel "step t (-)"
unset key
array Pre[3] = ["", "wrongP_", "wrongdP_"]
array Say[3] = ["all right", "wrong stress", "wrong tangent"]
set multiplot layout 1,3 margins 0.12,0.985,0.19,0.88 spacing 0.03,0
do for [panel = 1:3] {
    P = Pre[panel]."P"
    dP = Pre[panel]."dP"
    if (panel == 1) {
        set ylabel "Taylor remainder of ψ (J/m^3)"
        set format y "10^{%T}"
    } else {
        unset ylabel
        set format y ""
    }
    set title Say[panel] offset 0,-0.5
    a = panel == 2 ? 1 : 2
    b = panel == 1 ? 3 : a
    set label 1 sprintf(panel == 1 ? "first: slope %.2f" : \
        "both: slope %.2f", slope(P)) at (panel == 2 ? 0.006 : 9e-4), \
        (panel == 2 ? 5e-2 : 20) left textcolor ls 1 boxed
    set label 2 panel == 1 ? sprintf("second: slope %.2f", slope(dP)) : "" \
        at 0.3, 3e-7 right textcolor ls 2 boxed
    plot data index "taylor" using "t":P with linespoints ls 1, \
         "" index "taylor" using "t":dP with linespoints ls 2, \
         (panel == 2 ? 900 : 1800) * x**a with lines ls 8, \
         (panel == 1 ? 30 : NaN) * x**b with lines ls 8
}
unset multiplot
