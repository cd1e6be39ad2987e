# polar.gp - the modulus of a sheet with cords against the direction of the pull,
# and the shape of a square that is pulled along its cords, or at 20 degrees.
# Reads   data  tables polar, idle, pulled
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,810 enhanced font "Helvetica,18" \
    background rgb "white"
set output out
set multiplot
unset key
unset border
unset tics
unset grid
set size ratio -1
set tmargin at screen 0.998
set bmargin at screen 0.36
set lmargin at screen 0.005
set rmargin at screen 0.995
set xrange [-3700:3700]
set yrange [-3050:3050]
set samples 721
set parametric
set trange [0:360]
idle = system("awk -F'\t' '$0 == \"# idle\" { on = 1 } NF == 0 { on = 0 } \
    on { v = $1 } on && $1 + 0 > 0 { print v }' '".data."'") + 0.0
rad(d) = d * pi / 180.0
do for [r = 1:3] { # a little inside the first ring, outside the others
    at = 1000 * r - (r == 1 ? 170 : -120)
    set label r sprintf("%d", 1000 * r) at at * cos(rad(146)), \
        at * sin(rad(146)) center front boxed font ",17" tc rgb "#666666"
}
set label 3 "3000 N/m^2"
set label 5 "along the cords" at 2020, 190 center front boxed
set label 6 "without cords" at -1180, -330 right front boxed
set arrow 6 from -1165, -330 to -1070, -330 nohead lw 1.2
set label 7 "with cords" at 1900, 860 left tc rgb "#0072B2" front boxed
set label 8 sprintf("at %.0f° the cords\nadd nothing", idle) \
    at 1150, 1850 left front boxed
set label 9 "across" at 0, 1640 center
set arrow 1 from -3500, 0 to 3500, 0 nohead ls 9 lw 1
set arrow 2 from 0, -1500 to 0, 1480 nohead ls 9 lw 1
set arrow 5 from 0, 0 to 1990 * cos(rad(idle)), 1990 * sin(rad(idle)) nohead \
    dt 3 lw 1.5
set style textbox opaque noborder margins 0.5,0.5
set clip two
plot for [r = 1:3] 1000 * r * cos(rad(t)), 1000 * r * sin(rad(t)) \
         with lines ls 9 lw 0.7, \
     data index "polar" using (column("isotropic") * cos(rad(column("degrees")))): \
         (column("isotropic") * sin(rad(column("degrees")))) with lines ls 8 lw 2, \
     "" index "polar" using (column("modulus") * cos(rad(column("degrees")))): \
         (column("modulus") * sin(rad(column("degrees")))) with lines ls 1 lw 3
unset for [i = 1:9] label i
unset for [i = 1:6] arrow i
unset parametric

# F of the square that is pulled to 1.2: gamma, w
entry(angle, field) = system(sprintf( \
    "awk -F'\t' '$0 == \"# pulled\" { on = 1 } NF == 0 { on = 0 } \
     on && $1 == \"%d\" && ($2 - 1.2)^2 < 1e-9 { print $%d }' '%s'", \
    angle, field, data)) + 0.0
shape(angle) = sprintf( \
    "< awk 'BEGIN { l = 1.2; c = %.12f; w = %.12f; n = split(\"0 0 1 0 1 1 0 1 0 0\", p, \" \"); \
       for (k = 1; k < n; k += 2) print l * p[k] + c * p[k+1], w * p[k+1] }'", \
    entry(angle, 3), entry(angle, 4))
# cords 0.14 apart, clipped to the unit square, then deformed
cords(angle) = sprintf( \
    "< awk 'BEGIN { l = 1.2; g = %.12f; w = %.12f; a = %.12f; \
       c = cos(a); s = sin(a); \
       for (k = -12; k <= 12; k++) { ox = 0.5 - 0.14 * k * s; oy = 0.5 + 0.14 * k * c; \
         lo = -9; hi = 9; \
         if (c > 1e-9) { t = -ox / c; if (t > lo) lo = t; t = (1 - ox) / c; if (t < hi) hi = t } \
         if (s > 1e-9) { t = -oy / s; if (t > lo) lo = t; t = (1 - oy) / s; if (t < hi) hi = t } \
         else if (oy < 0 || oy > 1) continue; \
         if (lo >= hi) continue; \
         x = ox + lo * c; y = oy + lo * s; print l * x + g * y, w * y; \
         x = ox + hi * c; y = oy + hi * s; print l * x + g * y, w * y; print \"\" } }'", \
    entry(angle, 3), entry(angle, 4), rad(angle))
set datafile nocolumnheaders
set datafile separator whitespace
set tmargin at screen 0.36
set bmargin at screen 0.0
set xrange [-0.42:1.62]
set yrange [-0.42:1.1]
set object 1 rectangle from 0, 0 to 1, 1 front fs empty \
    border lc rgb "#444444" dt 3 lw 2
do for [i = 0:1] {
    angle = 20 * i
    set lmargin at screen (i ? 0.51 : 0.01)
    set rmargin at screen (i ? 0.99 : 0.49)
    set label 1 (i ? sprintf("pulled at 20°: its\nsides lean by %.1f°", \
        -atan(entry(20, 3) / entry(20, 4)) * 180 / pi) \
        : "pulled along its cords") at 0.6, -0.14 center
    set arrow 3 from (i ? 1.17 : 1.24), 0.46 to (i ? 1.45 : 1.52), 0.46 lw 2 \
        head filled size 0.05, 20
    set arrow 4 from (i ? -0.13 : -0.04), 0.46 to (i ? -0.41 : -0.32), 0.46 \
        lw 2 head filled size 0.05, 20
    plot shape(angle) using 1:2 with filledcurves closed fc rgb "#CFE3F0", \
         shape(angle) using 1:2 with lines ls 1, \
         cords(angle) using 1:2 with lines lw 1.5 lc rgb "#D55E00"
}
unset multiplot
