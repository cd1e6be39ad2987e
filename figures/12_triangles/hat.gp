# hat.gp - a schematic: the hat function of a vertex over its six triangles, and
# the gradient of a hat on one triangle.  All places are computed here.
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,330 enhanced font "Helvetica,15"
set output out
unset key
unset border
unset tics
unset grid
set size ratio -1
set multiplot
set tmargin at screen 0.98
set bmargin at screen 0.03

# ---- the hat: vertices (i, j), height z, drawn obliquely ---------------------
h = 1.45
sx(i, j) = 1.05 * i + 0.28 * j
sy(i, j, z) = 0.46 * j - 0.10 * i + h * z
set lmargin at screen 0.01
set rmargin at screen 0.53
set xrange [-1.55:1.6]
set yrange [-0.95:1.85]
line = 0
# the mesh: the squares are cut from lower left to upper right
do for [k = -1:1] {
    line = line + 1
    set arrow line from sx(-1, k), sy(-1, k, 0) to sx(1, k), sy(1, k, 0) nohead \
        lw 1 lc rgb "#999999"
    line = line + 1
    set arrow line from sx(k, -1), sy(k, -1, 0) to sx(k, 1), sy(k, 1, 0) nohead \
        lw 1 lc rgb "#999999"
}
do for [i = -1:0] { do for [j = -1:0] {
    line = line + 1
    set arrow line from sx(i, j), sy(i, j, 0) to sx(i + 1, j + 1), \
        sy(i + 1, j + 1, 0) nohead lw 1 lc rgb "#999999"
} }
# its six neighbours, once round
array ri = [1, 1, 0, -1, -1, 0, 1]
array rj = [0, 1, 1, 0, -1, -1, 0]
do for [k = 1:6] {
    set object k polygon from sx(0, 0), sy(0, 0, 1) to sx(ri[k], rj[k]), \
        sy(ri[k], rj[k], 0) to sx(ri[k + 1], rj[k + 1]), \
        sy(ri[k + 1], rj[k + 1], 0) to sx(0, 0), sy(0, 0, 1) \
        fs transparent solid 0.35 noborder fc rgb "#7FB8DA" front
    line = line + 1
    set arrow line from sx(0, 0), sy(0, 0, 1) to sx(ri[k], rj[k]), \
        sy(ri[k], rj[k], 0) nohead lw 1.5 lc rgb "#0072B2" front
    line = line + 1
    set arrow line from sx(ri[k], rj[k]), sy(ri[k], rj[k], 0) to \
        sx(ri[k + 1], rj[k + 1]), sy(ri[k + 1], rj[k + 1], 0) nohead lw 1.5 \
        lc rgb "#0072B2" front
}
set arrow 90 from 0, 0 to 0, h nohead lw 1.5 dt 2 lc rgb "black" front
set label 1 "{/:Italic a}" at 0.10, 0.09 left front
set label 2 "1" at 0.05, 0.38 * h left front
set label 3 "{/:Italic N_a}" at 0.0, h + 0.17 center
set label 4 "0 at every other vertex" at 0.1, -0.82 center
plot "+" using (0):(0) every ::0::0 with points pt 7 ps 0.6 lc rgb "black"
unset arrow
unset object
unset label

# ---- one triangle -------------------------------------------------------------
set lmargin at screen 0.54
set rmargin at screen 0.99
array x = [0, 1.7, 1.1]
array y = [0, 0.25, 1.5]
eX = x[2] - x[1]
eY = y[2] - y[1]
edge = sqrt(eX**2 + eY**2)
nX = -eY / edge            # perpendicular to the edge 0 1, towards vertex 2
nY = eX / edge
height = nX * (x[3] - x[1]) + nY * (y[3] - y[1])
fX = x[3] - height * nX    # the foot of the height
fY = y[3] - height * nY
set xrange [-0.3:2.55]
set yrange [-0.6:1.9]
set object 1 polygon from x[1], y[1] to x[2], y[2] to x[3], y[3] to x[1], y[1] \
    fs solid 1 noborder fc rgb "#CFE3F0" behind
do for [k = 1:3] {
    l = k % 3 + 1
    set arrow k from x[k], y[k] to x[l], y[l] nohead lw 1.5 lc rgb "#0072B2"
    # where the hat of vertex 2 has the value k / 4
    set arrow 3 + k from x[1] + k / 4.0 * (x[3] - x[1]), \
        y[1] + k / 4.0 * (y[3] - y[1]) to x[2] + k / 4.0 * (x[3] - x[2]), \
        y[2] + k / 4.0 * (y[3] - y[2]) nohead lw 1 lc rgb "#0072B2"
    set label 3 + k sprintf("%.2g", k / 4.0) at x[2] + k / 4.0 * (x[3] - x[2]) \
        + 0.08, y[2] + k / 4.0 * (y[3] - y[2]) left tc rgb "#0072B2"
}
set arrow 7 from fX, fY to x[3], y[3] nohead lw 1.5 dt 2 lc rgb "black"
set arrow 8 from 0.62, 0.3 to 0.62 + nX / height, 0.3 + nY / height lw 2.5 \
    lc rgb "#D55E00" head filled size 0.1, 20 front
set label 1 "0" at x[1] - 0.1, y[1] - 0.08 right
set label 2 "1" at x[2] + 0.08, y[2] - 0.1 left
set label 3 "2" at x[3], y[3] + 0.14 center
set label 7 "∇{/:Italic N}_2" at 0.62 + nX / height + 0.02, 0.3 + nY / height + 0.13 \
    right front tc rgb "#D55E00"
set label 8 "lines of equal" at 1.25, -0.48 right
set label 9 "{/:Italic N}_2" at 1.32, -0.48 left
plot NaN notitle
unset multiplot
