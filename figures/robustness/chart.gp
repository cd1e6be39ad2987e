# chart.gp - the chart of the course: methods and laws by scenes, three above three.
# Reads   data  table chart (method law scene passed passed_se systems
#               ms error), machine
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,1380
set output out

array Title[6] = ["stretch", "jerk", "press", "crush", "scramble\ninside", \
                  "scramble\nall"]
number(s) = s eq "stretch" ? 0 : s eq "jerk" ? 1 : s eq "press" ? 2 : \
            s eq "crushed" ? 3 : s eq "scrambled_held" ? 4 : 5
# the column of a scene in the panel g
x_of(s) = int(number(s) / 3) == g ? number(s) % 3 + 1 : NaN
y_of(i) = -floor(i / 6)
label_of(m) = m eq "notes" ? "notes' method" : m eq "lift" ? \
    "lift, extrapolation" : m eq "search" ? "line search" : \
    m eq "demand+search" ? "on demand, search" : "always, search"
# the first row, from the top, that passes a scene wholly
array Seen[6] = [0, 0, 0, 0, 0, 0]
first(k) = int((k - 1) / 3) == g && column("passed") == 100 && !Seen[k] ? \
    (Seen[k] = 1) : 0
shade(p) = p == 100 ? 0xCBE8DC : p > 0 ? 0xFBE3C4 : 0xF3D3D8
count(n) = sprintf(n < 9.95 ? "%.1f" : "%.0f", n)
all(i) = column("passed") == 100 ? count(column("systems")) : \
    column("passed") > 0 ? sprintf("%.0f%s %%", column("passed"), unsure(i)) : \
    "failed"
unsure(i) = stringcolumn("passed_se") eq "-" ? "" : \
    sprintf(" ± %.0f", column("passed_se"))
ms(t) = sprintf(t < 9.95 ? "%#.2g ms" : "%.0f ms", t)
price(i) = column("passed") > 0 ? (column("passed") < 100 ? \
    count(column("systems"))."; ".ms(column("ms")) : ms(column("ms"))) : ""
set multiplot
unset key
unset border
unset grid
unset xtics
unset ytics
set lmargin at screen 0.01
set rmargin at screen 0.99
set xrange [-1.02:4.48]
set yrange [-11.5:0.5]
set label 10 machine(data) at screen 0.985,0.010 right textcolor rgb "#555555"
do for [g = 0:1] {
    set tmargin at screen 0.953 - 0.492 * g
    set bmargin at screen 0.521 - 0.492 * g
    do for [k = 1:3] {
        set label k Title[3 * g + k] at first k, screen 0.982 - 0.492 * g center
    }
    set label 7 "stress error\nat 1.1 (%)" at first 3.98, screen 0.982 - 0.492 * g center
    set label 8 "method\nlaw" at first -1, screen 0.982 - 0.492 * g left
    plot data index "chart" using (x_of(strcol("scene"))):(y_of($0)): \
             (x_of(strcol("scene")) - 0.48):(x_of(strcol("scene")) + 0.48): \
             (y_of($0) - 0.46):(y_of($0) + 0.46):(shade(column("passed"))) \
             with boxxyerror lc rgb variable fs solid noborder, \
         "" index "chart" using (first(number(strcol("scene")) + 1) ? \
                 x_of(strcol("scene")) : NaN):(y_of($0)): \
             (x_of(strcol("scene")) - 0.48):(x_of(strcol("scene")) + 0.48): \
             (y_of($0) - 0.46):(y_of($0) + 0.46) \
             with boxxyerror fs empty border lc rgb "#009E73" lw 3, \
         "" index "chart" using (x_of(strcol("scene"))):(y_of($0) + \
             (column("passed") > 0 ? 0.18 : 0)):(all(0)) with labels, \
         "" index "chart" using (x_of(strcol("scene"))):(y_of($0) - 0.22): \
             (price(0)) with labels textcolor rgb "#444444", \
         "" index "chart" using (3.98):(y_of($0)):(int($0) % 6 == 0 ? \
             sprintf("%.2g", column("error")) : "") with labels, \
         "" index "chart" using (-1):(y_of($0) + 0.18):(int($0) % 6 == 0 ? \
             label_of(strcol("method")) : "") with labels left, \
         "" index "chart" using (-1):(y_of($0) - 0.22):(int($0) % 6 == 0 ? \
             strcol("law") : "") with labels left textcolor rgb "#444444"
}
unset multiplot
