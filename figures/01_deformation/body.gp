# body.gp - a schematic: a body and its map; below, what F does to the edges of a
# triangle.  All places and J are computed here.  The space behind an index is one
# that does not break, which every viewer keeps.
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,530 enhanced font "Helvetica,15"
set output out
unset key
unset border
unset tics
unset grid
set size ratio -1
set multiplot
set lmargin at screen 0.01
set rmargin at screen 0.99

# ---- body and map --------------------------------------------------------------
# The body is a blob; grid lines of the material go with it.
R(t) = 1 + 0.10 * cos(2 * t - 0.6) + 0.07 * cos(3 * t + 0.4)
BX(t) = 1.25 * R(t) * cos(t)
BY(t) = R(t) * sin(t)
far = 3.6                  # the deformed body is drawn this much to the right
x(X, Y) = 0.95 * X + 0.30 * Y + 0.12 * X * X
y(X, Y) = 0.25 * X + 1.15 * Y - 0.16 * X * X
F11(X, Y) = 0.95 + 0.24 * X
F12 = 0.30
F21(X, Y) = 0.25 - 0.32 * X
F22 = 1.15

# a point, and a short edge there
X0 = -0.35
Y0 = -0.30
eX = 0.42
eY = 0.30

set tmargin at screen 0.995
set bmargin at screen 0.4925
set xrange [-1.55:5.65]
set yrange [-1.62:1.24]
set parametric
set trange [0:2 * pi]
set samples 400
inside(X, Y) = sqrt((X / 1.25)**2 + Y**2) < R(atan2(Y, X / 1.25))
cut(X, Y) = inside(X, Y) ? X : NaN
set arrow 1 from X0, Y0 to X0 + eX, Y0 + eY lw 2.5 lc rgb "#0072B2" \
    head filled size 0.14, 20 front
set arrow 2 from far + x(X0, Y0), y(X0, Y0) to \
    far + x(X0, Y0) + F11(X0, Y0) * eX + F12 * eY, \
    y(X0, Y0) + F21(X0, Y0) * eX + F22 * eY lw 2.5 lc rgb "#0072B2" \
    head filled size 0.14, 20 front
set arrow 3 from 1.55, 0.55 to 2.25, 0.55 lw 1.5 lc rgb "black" \
    head filled size 0.14, 20 front
set label 1 "{/:Italic φ}" at 1.9, 0.75 center
set label 2 "{/:Italic X}" at X0 - 0.10, Y0 - 0.13 right \
    front
set label 3 "{/:Italic x = φ(X)}" at \
    far + x(X0, Y0), y(X0, Y0) - 0.2 center front
set label 4 "{/:Italic dX}" at X0 + eX + 0.04, Y0 + eY + 0.13 left front \
    tc rgb "#0072B2"
set label 5 "{/:Italic F dX}" at \
    far + x(X0, Y0) + F11(X0, Y0) * eX + F12 * eY + 0.05, \
    y(X0, Y0) + F21(X0, Y0) * eX + F22 * eY + 0.12 left front tc rgb "#0072B2"
set label 6 "at rest" at 0, -1.42 center
set label 7 "deformed" at far + 0.2, -1.42 center
plot BX(t), BY(t) with filledcurves closed fc rgb "#CFE3F0", \
     far + x(BX(t), BY(t)), y(BX(t), BY(t)) with filledcurves closed \
         fc rgb "#CFE3F0", \
     for [k = -5:5] cut(k * 0.3, (t - pi) / 2), (t - pi) / 2 with lines lw 0.5 \
         lc rgb "#0072B2", \
     for [k = -4:4] cut((t - pi) / 2, k * 0.3), k * 0.3 with lines lw 0.5 \
         lc rgb "#0072B2", \
     for [k = -5:5] far + x(cut(k * 0.3, (t - pi) / 2), (t - pi) / 2), \
         y(k * 0.3, (t - pi) / 2) with lines lw 0.5 lc rgb "#0072B2", \
     for [k = -4:4] far + x(cut((t - pi) / 2, k * 0.3), k * 0.3), \
         y((t - pi) / 2, k * 0.3) with lines lw 0.5 lc rgb "#0072B2", \
     BX(t), BY(t) with lines lw 1.5 lc rgb "black", \
     far + x(BX(t), BY(t)), y(BX(t), BY(t)) with lines lw 1.5 lc rgb "black", \
     "+" using (X0):(Y0) every ::0::0 with points pt 7 ps 0.7 lc rgb "black", \
     "+" using (far + x(X0, Y0)):(y(X0, Y0)) every ::0::0 with points pt 7 \
         ps 0.7 lc rgb "black"
unset arrow
unset label

# ---- edges of a triangle ------------------------------------------------------
array px = [0, 1.25, 0.35, 2.55, 3.95, 3.25, 5.05, 6.5, 6.3]
array py = [0, 0.15, 1.15, 0.1, 0.45, 1.35, 0.95, 1.2, 0.15]
det(k) = (px[k + 1] - px[k]) * (py[k + 2] - py[k]) \
         - (px[k + 2] - px[k]) * (py[k + 1] - py[k])
set tmargin at screen 0.4706
set bmargin at screen 0.011
unset parametric
set xrange [-0.35:7.15]
set yrange [-0.75:1.75]
do for [k = 1:7:3] {
    name = k == 1 ? "X" : "x"
    set object k polygon from px[k], py[k] to px[k + 1], py[k + 1] to \
        px[k + 2], py[k + 2] to px[k], py[k] fs solid 1 noborder \
        fc rgb (k == 7 ? "#F7D9C4" : "#CFE3F0") behind
    set arrow 10 * k from px[k + 1], py[k + 1] to px[k + 2], py[k + 2] nohead \
        lw 1 lc rgb "black"
    set arrow 10 * k + 1 from px[k], py[k] to px[k + 1], py[k + 1] lw 2.5 \
        lc rgb "#0072B2" head filled size 0.14, 20 front
    set arrow 10 * k + 2 from px[k], py[k] to px[k + 2], py[k + 2] lw 2.5 \
        lc rgb "black" head filled size 0.14, 20 front
    cx = (px[k] + px[k + 1] + px[k + 2]) / 3.0
    cy = (py[k] + py[k + 1] + py[k + 2]) / 3.0
    do for [a = 0:2] { # away from the middle
        dx = px[k + a] - cx
        dy = py[k + a] - cy
        d = sqrt(dx**2 + dy**2)
        set label 10 * k + a "{/:Italic ".name."}_".a at \
            px[k + a] + 0.20 * dx / d, py[k + a] + 0.20 * dy / d center front
    }
}
set label 1 "{/:Italic D_m = (X_1 − X_0, X_2 − X_0)}" at 0.6, -0.5 center
set label 2 "{/:Italic D_s = (x_1 − x_0, x_2 − x_0)}" at 4.5, -0.5 center
set label 3 sprintf("{/:Italic J = }%.2f", det(4) / det(1)) at 3.5, -0.08 center \
    front
set label 4 sprintf("{/:Italic J = }−%.2f", -det(7) / det(1)) at 5.2, 0.25 \
    center front
set label 5 "{/:Italic F}" at 1.85, 0.95 center
set arrow 1 from 1.5, 0.75 to 2.2, 0.75 lw 1.5 lc rgb "black" head filled \
    size 0.14, 20 front
set label 6 "or" at 4.45, 0.75 center
plot NaN notitle
unset multiplot
