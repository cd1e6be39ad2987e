# paths.gp - the three laws in the plane, along four paths.
# Reads   data  tables equibiaxial_LAW, uniaxial_LAW, shear_LAW, rotation_LAW
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 860,740 enhanced font "Helvetica,17"
set output out

set multiplot
unset key
array Path[4] = ["equibiaxial", "uniaxial", "shear", "rotation"]
array Text[4] = ["F = diag(s, s)", "F = diag(s, 1)", "F = [1 s; 0 1]", \
                 "F = rotation by s"]
array Axis[4] = ["stretch s (-)", "stretch s (-)", "shear s (-)", \
                 "angle s (degrees)"]
do for [p = 1:4] {
    set lmargin at screen (p % 2 ? 0.12 : 0.63)
    set rmargin at screen (p % 2 ? 0.48 : 0.98)
    set tmargin at screen (p < 3 ? 0.95 : 0.445)
    set bmargin at screen (p < 3 ? 0.63 : 0.115)
    set xlabel Axis[p]
    set ylabel (p == 3 ? "P_{12}  (N/m^2)" : "P_{11}  (N/m^2)") offset 0.5
    set title Text[p] offset 0,-0.5
    if (p == 1) { set xrange [-1.5:2.5]; set yrange [-8000:8000]; set xtics 1; set ytics 4000 }
    if (p == 2) { set xrange [-1:3]; set yrange [-8000:5000]; set ytics 4000 }
    if (p == 3) { set xrange [0:2]; set yrange [0:900]; set xtics 0.5; set ytics 200 }
    if (p == 4) { set xrange [0:180]; set yrange [-4500:1000]; set xtics 45; set ytics 1000 }
    set label 2 (p == 1 ? "turned\nby 180°:\nat rest" : p == 3 ? \
        "all three agree" : p == 4 ? "log, cubic: no stress" : "") \
        at graph (p == 1 ? 0.03 : p == 3 ? 0.55 : 0.4), \
        graph (p == 1 ? 0.93 : p == 3 ? 0.42 : 0.93) \
        textcolor rgb "#555555" boxed
    set label 3 (p < 3 ? "log" : "") \
        at (p == 1 ? 0.5 : 0.4), -6500 left textcolor ls 1 boxed
    set label 4 (p < 3 ? "cubic" : "") \
        at (p == 1 ? 1.5 : -0.3), (p == 1 ? 6000 : -6500) right textcolor ls 2 boxed
    if (p == 1) { set label 5 "linear" at -0.9, -4800 left boxed }
    if (p == 2) { set label 5 "linear" at -0.95, -1200 left boxed }
    if (p == 3) { unset label 5 }
    if (p == 4) { set label 5 "linear" at 80, -2300 right boxed }
    if (p == 1) { set arrow 1 from -1.0, 2800 to -1.0, 350 ls 9 lw 1 }
    if (p > 1) { unset arrow 1 }
    plot data index Path[p]."_log" using "s":"P" with lines ls 1 \
             lw (p > 2 ? 8 : 2), \
         "" index Path[p]."_cubic" using "s":"P" with lines ls 2 \
             lw (p > 2 ? 4 : 2), \
         "" index Path[p]."_linear" using "s":"P" with lines ls 8 lw 1.5, \
         0 with lines ls 9
}
unset multiplot
