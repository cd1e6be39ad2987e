# chart.gp - the chart of the course: methods and laws by scenes.
# Reads   data  table chart (method law scene passed passed_se systems
#               ms error), machine
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,500
set output out

array Scene[6] = ["stretch", "jerk", "press", "crushed", "scrambled_held", \
                  "scrambled_free"]
array Title[6] = ["stretch", "jerk", "press past\nthe limit", "crush and\nlet go", \
                  "scramble\ninside", "scramble\nall"]
x_of(s) = s eq "stretch" ? 1 : s eq "jerk" ? 2 : s eq "press" ? 3 : \
          s eq "crushed" ? 4 : s eq "scrambled_held" ? 5 : 6
y_of(i) = -floor(i / 6)
label_of(m) = m eq "notes" ? "plain" : m eq "search" ? "line search" : \
    m eq "demand+search" ? "projection on demand" : "projection always"
unset key
unset border
unset grid
unset xtics
unset ytics
set lmargin at screen 0.01
set rmargin at screen 0.99
set tmargin at screen 0.86
set bmargin at screen 0.07
set xrange [-2.1:7.5]
set yrange [-8.5:0.5]
do for [k = 1:6] {
    set label k Title[k] at first k, screen 0.945 center font ",13"
}
set label 7 "stress error\nat 1.1 (%)" at first 7, screen 0.945 center font ",13"
set label 8 "method" at screen 0.02, screen 0.925 left font ",13"
set label 9 "law" at screen 0.188, screen 0.925 left font ",13"
set label 10 machine(data) at screen 0.985,0.025 right font ",10" \
    textcolor rgb "#555555"
set label 11 "linear systems and milliseconds per step or start that passes; frame: the first row that always does" \
    at screen 0.02,0.025 left font ",11" textcolor rgb "#555555"
# the first row, from the top, that passes a scene wholly
array Seen[6] = [0, 0, 0, 0, 0, 0]
first(k) = column("passed") == 100 && !Seen[k] ? (Seen[k] = 1) : 0
shade(p) = p == 100 ? 0xCBE8DC : p > 0 ? 0xFBE3C4 : 0xF3D3D8
count(n) = sprintf(n < 9.95 ? "%.1f" : "%.0f", n)
all(i) = column("passed") == 100 ? count(column("systems")) : \
    column("passed") > 0 ? sprintf("%.0f%s %%", column("passed"), unsure(i)) : \
    "failed"
unsure(i) = stringcolumn("passed_se") eq "-" ? "" : \
    sprintf(" ± %.0f", column("passed_se"))
price(i) = column("passed") > 0 ? (column("passed") < 100 ? \
    count(column("systems")).sprintf("; %.2g ms", column("ms")) : \
    sprintf("%.2g ms", column("ms"))) : ""
plot data index "chart" using (x_of(stringcolumn("scene"))):(y_of($0)): \
         (x_of(stringcolumn("scene")) - 0.48): \
         (x_of(stringcolumn("scene")) + 0.48):(y_of($0) - 0.46): \
         (y_of($0) + 0.46):(shade(column("passed"))) \
         with boxxyerror lc rgb variable fs solid noborder, \
     "" index "chart" using (first(x_of(stringcolumn("scene"))) ? \
             x_of(stringcolumn("scene")) : NaN):(y_of($0)): \
         (x_of(stringcolumn("scene")) - 0.48): \
         (x_of(stringcolumn("scene")) + 0.48):(y_of($0) - 0.46): \
         (y_of($0) + 0.46) with boxxyerror fs empty border lc rgb "#009E73" \
         lw 3, \
     "" index "chart" using (x_of(stringcolumn("scene"))):(y_of($0) + \
         (column("passed") > 0 ? 0.15 : 0)):(all(0)) \
         with labels font ",13", \
     "" index "chart" using (x_of(stringcolumn("scene"))):(y_of($0) - 0.2): \
         (price(0)) with labels font ",10" textcolor rgb "#444444", \
     "" index "chart" using (7):(y_of($0)):(int($0) % 6 == 0 ? \
         sprintf("%.2g", column("error")) : "") with labels font ",13", \
     "" index "chart" using (-2.0):(y_of($0)):(int($0) % 6 == 0 ? \
         label_of(stringcolumn("method")) : "") with labels left font ",12", \
     "" index "chart" using (-0.35):(y_of($0)):(int($0) % 6 == 0 ? \
         stringcolumn("law") : "") with labels left font ",12"
set output
