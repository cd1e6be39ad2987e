# tissue.gp - a wound that two hooks open, half way and at full pull, over the
# block at rest (grey); the forces of the hooks, to scale, and the least J.
# Reads   data  tables pull, strip
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,725 font "Helvetica,17"
set output out
set multiplot
set style fill solid noborder
unset key
unset grid
unset border
unset tics
set size ratio -1
set lmargin at screen 0
set rmargin at screen 1
set datafile nocolumnheaders
set datafile separator whitespace
set xrange [-54.5:54.5]

# From table strip, in mm: strips of a layer, once around each; the upper sides
# of all of them; lines across them.  From table pull: a cell.  Of the vertices
# of a strip it takes the ends and one of `step`, the same ones in strips that
# begin behind the wound, in the middle.
rows(when, layer, step, do) = sprintf("< awk -F'\t' 'function end() { \
        shift = low[1] + 0 > 0 ? n : 0; \
        for (i = 1; i <= n; i++) if (i == 1 || i == n || \
            (i + shift) %% %d == 1 %% %d) { %s } \
        for (; m > 0; m--) print back[m]; print \"\"; n = 0 } \
    END { end() } $1 == \"%s\" && NF == 7 && $2 ~ /%s/ { \
        if ($3 != strip) end(); strip = $3; \
        low[++n] = 1e3 * $4 \" \" 1e3 * $5; \
        high[n] = 1e3 * $6 \" \" 1e3 * $7 }' '%s'", step, step, do, when, \
    layer, data)
around(when, layer, step) = \
    rows(when, layer, step, "print low[i]; back[++m] = high[i]")
upper(when) = rows(when, ".", 2, "print high[i]")
across(when) = rows(when, ".", 4, "print low[i]; print high[i]; print \"\"")
pull(column) = system(sprintf("awk -F'\t' '$1 == \"%s\" && NF == 11 { \
    print $%d }' '%s'", w, column, data)) + 0.0

# A hook: from its centre straight out of the skin (q < 1), round (q < 2), and
# off where the force goes (q < 3); the right one (side = 1) is mirrored.
set angles degrees
set samples 121
R = 2.6
along(q) = q < 1 ? q * 5.2 - 0.6 : 4.6
round(q) = bend * (q < 1 ? 0 : q < 2 ? q - 1 : 1)
shaft(q) = q < 2 ? 0 : (q - 2) * 7
X(q) = along(q) + R * sin(round(q)) + shaft(q) * cos(bend)
Y(q) = R * (1 - cos(round(q))) + shaft(q) * sin(bend)
hx(q, side) = -side * (cx + X(q) * cos(turn) - Y(q) * sin(turn))
hy(q) = cy + X(q) * sin(turn) + Y(q) * cos(turn)

array When[2] = ["half", "full"]
array Title[2] = ["half way", "full pull"]
array Top[2] = [37, 45]
do for [k = 1:2] {
    w = When[k]
    edge = (Top[2] + 20.5) / (Top[1] + Top[2] + 41.0)
    set tmargin at screen k == 1 ? 1.0 : edge
    set bmargin at screen k == 1 ? edge : 0.0
    set yrange [-20.5:Top[k]]
    cx = 1e3 * pull(2)
    cy = 1e3 * pull(3)
    turn = pull(4)
    bend = atan2(pull(6), pull(5)) - turn
    set object 1 rectangle from -53, -18.5 to 53, -15 fc rgb "#EFE9DA" fs solid noborder behind
    set label 1 Title[k] at -53, Top[k] - 4 font ",18"
    set label 2 sprintf("least J = %.2f", pull(9)) at -53, Top[k] - 9
    set label 4 "skin" at -49, 17.8 front
    set label 5 "fat" at -47, 8 front
    set label 6 "muscle" at -47, -4 front tc rgb "white"
    set label 7 "bone" at -47, -16.8 front
    set arrow 1 from 42, 24 to 52, 24 nohead lw 3
    set label 3 "1 cm" at 47, 26.7 center
    F = 130 * pull(8) # 130 mm per N
    fx = F * cos(turn + bend)
    fy = F * sin(turn + bend)
    do for [side = -1:1:2] {
        set arrow 3 + side from hx(3, side), hy(3) rto -side * fx, fy \
            size 1.6, 20 filled front lw 2.5 lc rgb "#D55E00"
    }
    set label 8 sprintf("%.3f N", pull(8)) tc rgb "#D55E00" \
        at hx(3, 1) - fx + 1.5, hy(3) + fy - 1
    plot around("rest", ".", 51) with filledcurves closed fc rgb "#DDDDDD", \
         around(w, "muscle", 2) with filledcurves closed fc rgb "#B3473F", \
         around(w, "fat", 2) with filledcurves closed fc rgb "#F3D07A", \
         around(w, "skin", 2) with filledcurves closed fc rgb "#E3A787", \
         upper(w) with lines lw 0.6 lc rgb "#B0401000", \
         across(w) with lines lw 0.6 lc rgb "#B0401000", \
         for [side = -1:1:2] [q = 0:3] "+" using (hx($1, side)):(hy($1)) \
             with lines lw 6 lc rgb "#46525E", \
         for [side = -1:1:2] [q = 0:3] "+" using (hx($1, side)):(hy($1)) \
             with lines lw 1.5 lc rgb "#C9D3DC"
}
unset multiplot
