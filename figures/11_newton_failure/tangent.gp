# tangent.gp - a schematic: the first step of Newton's method for one element,
# to two loads; and the start of a bar whose left end is moved, as it is and
# lifted.  The stress is that of the log law, nu = 0.3, over 2 mu + lambda; all
# places are computed here.
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 680,340 enhanced font "Helvetica,15"
set output out
unset key
unset grid
unset tics
unset border
set multiplot
set tmargin at screen 0.93
set bmargin at screen 0.10

# ---- the tangent --------------------------------------------------------------
lambda = 1.5               # over mu
P(F) = (F + (lambda * log(F) - 1) / F) / (2 + lambda)
dP(F) = (1 + (1 + lambda - lambda * log(F)) / F**2) / (2 + lambda)
F0 = 1.4
near = -0.19               # two loads: this one is survived,
far = -0.77                # and this one is not
landing(p) = F0 + (p - P(F0)) / dP(F0)
tangent(F) = P(F0) + dP(F0) * (F - F0)
set lmargin at screen 0.03
set rmargin at screen 0.53
set xrange [-0.75:2.2]
set yrange [-1.3:0.75]
set samples 1000
set object 1 rect from -0.75, -1.3 to 0, 0.75 fc rgb "#F7D9C4" \
    fs solid 1 noborder behind
set arrow 1 from -0.75, 0 to 2.2, 0 lw 1 lc rgb "black" head size 0.08, 20
set arrow 2 from 0, -1.3 to 0, 0.75 lw 1 lc rgb "black" head size 0.08, 20
set arrow 3 from -0.75, near to 2.1, near nohead lw 1 dt 2 lc rgb "#009E73"
set arrow 4 from -0.75, far to 2.1, far nohead lw 1 dt 2 lc rgb "#D55E00"
set arrow 5 from landing(near), near to landing(near), P(landing(near)) lw 1 \
    dt 3 lc rgb "#009E73" nohead
set label 1 "{/:Italic P}" at 0.1, 0.66 left
set label 2 "{/:Italic F}" at 2.15, 0.12 center
set label 3 "{/:Italic F}_0" at F0 + 0.05, P(F0) - 0.14 left
set label 4 "load 1" at 2.15, near - 0.08 right tc rgb "#009E73"
set label 5 "load 2" at 2.15, far + 0.08 right tc rgb "#D55E00"
set label 6 "{/:Italic F}_1" at landing(near) - 0.06, near + 0.11 right \
    tc rgb "#009E73"
set label 7 "{/:Italic F}_1" at landing(far), far - 0.12 center \
    tc rgb "#D55E00"
set label 8 "no log law" at -0.73, 0.66 left
set label 9 "log law" at 0.50, -1.2 left tc rgb "#0072B2"
plot sample [0.2:2.2] P(x) with lines lw 2.5 lc rgb "#0072B2", \
     [landing(far):2.1] tangent(x) with lines lw 2 lc rgb "#D55E00", \
     [landing(near):2.1] tangent(x) with lines lw 2 lc rgb "#009E73", \
     "+" using (F0):(P(F0)) every ::0::0 with points pt 7 ps 0.8 \
         lc rgb "black", \
     "+" using (landing(near)):(near) every ::0::0 with points pt 7 ps 0.8 \
         lc rgb "#009E73", \
     "+" using (landing(far)):(far) every ::0::0 with points pt 2 ps 1.1 lw 2.5 \
         lc rgb "#D55E00"
unset object
unset arrow
unset label

# ---- the lift: places of the nodes, from the moved end to the held one --------
n = 5
now(k) = 1.12 * k          # before the step
jump = 1.4 * 1.12          # of the left end
lifted(k) = now(k) + jump * (1 - k / (n + 0.0))
place(row, k) = row == 2 ? lifted(k) : row == 1 && k == 0 ? jump : now(k)
set lmargin at screen 0.60
set rmargin at screen 0.99
set xrange [-0.6:n + 0.9]
set yrange [-0.9:4.1]
do for [row = 0:2] {
    h = 3.2 - 1.45 * row
    set label 10 + row word("before usual lifted", row + 1).(row == 0 ? \
        " the step" : " start") at now(n), h + 0.45 right
    do for [k = 1:n] {
        a = place(row, k - 1)
        b = place(row, k)
        # an element that is inside out lies over the next one
        set arrow 10 * row + k from a, h + (b < a ? 0.16 : 0) to \
            b, h + (b < a ? 0.16 : 0) nohead lw (b < a ? 5 : 3) \
            lc rgb (b < a ? "#D55E00" : "#0072B2")
        set object 10 * row + k circle at b, h size 0.09 fs solid 1 noborder \
            fc rgb "black" front
    }
    set object 10 * row + 9 circle at place(row, 0), h size 0.09 \
        fs solid 1 noborder fc rgb "black" front
}
set arrow 40 from 0, 3.05 to 0, -0.35 nohead lw 1 dt 2 lc rgb "#999999"
set arrow 41 from jump, 3.05 to jump, -0.35 nohead lw 1 dt 2 lc rgb "#999999"
set arrow 42 from 0, -0.45 to jump, -0.45 lw 1.5 lc rgb "black" head filled \
    size 0.2, 20
set label 1 "Δ{/:Italic g}" at jump / 2, -0.75 center
set label 2 "{/:Italic F < 0}" at jump + 0.15, 2.12 left tc rgb "#D55E00"
plot NaN notitle
unset multiplot
