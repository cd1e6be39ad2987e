# meshes.gp - a square pushed inside with its boundary held, before
# and after, inverted triangles coloured, with the exact curve J = 0; and a
# strip in a loop: J > 0 everywhere, and a part of it covered twice.
# Reads   data  tables square, strip (one row per triangle)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 600,690 enhanced font "Helvetica,14"
set output out
unset key
unset grid

# The triangles of a table as closed polygons: `first` is the column of x0,
# `test` an awk condition on a row; J is $1, the owners $2.
polygons(table, first, test) = sprintf( \
    "< awk -F'\t' '$0 == \"# %s\" { on = 1; next } NF == 0 { on = 0 } \
     on == 1 { on = 2; print \"x\ty\"; next } \
     on == 2 && (%s) { for (k = 0; k < 4; k++) \
         print $(%d + 2 * (k %% 3)) \"\t\" $(%d + 1 + 2 * (k %% 3)); \
         print \"\" }' '%s'", table, test, first, first, data)
# The edges of the triangles of a table, each once, in as few lines as walks
# along them take.
edges(table, first) = sprintf( \
    "< awk -F'\t' '$0 == \"# %s\" { on = 1; next } NF == 0 { on = 0 } \
     on == 1 { on = 2; next } \
     on == 2 { for (k = 0; k < 3; k++) { \
         a = vertex($(%d + 2 * k) \"\t\" $(%d + 1 + 2 * k)); \
         b = vertex($(%d + 2 * ((k + 1) %% 3)) \"\t\" \
                    $(%d + 1 + 2 * ((k + 1) %% 3))); \
         if (!seen[a, b]++ && !seen[b, a]++) { \
             to[a, ++n[a]] = b; to[b, ++n[b]] = a } } } \
     function vertex(xy) { if (!(xy in id)) { id[xy] = ++last; at[last] = xy } \
         return id[xy] } \
     function next_of(v,  i) { for (i = 1; i <= n[v]; i++) \
         if (!gone[v, to[v, i]]) return to[v, i]; return 0 } \
     END { print \"x\ty\"; for (v = 1; v <= last; v++) while (next_of(v)) { \
         w = v; print at[w]; while ((u = next_of(w))) { \
             gone[w, u] = gone[u, w] = 1; print at[u]; w = u } print \"\" } }' \
     '%s'", table, first, first, first, first, data)
# the push of the scene: how far the centre goes
s = system("awk -F'\t' '$0 == \"# square\" { on = 1 } NF == 0 { on = 0 } \
            on { for (k = 3; k <= 7; k += 2) \
                 if ($(k + 6) == \"0\" && $(k + 7) == \"0\") s = $k } \
            END { print s }' '".data."'") + 0.0

set style fill solid noborder
set multiplot
set tmargin at screen 0.955
set bmargin at screen 0.615
set border 15 back ls 9
set size ratio -1
set xrange [-1.2:1.2]
set yrange [-1.2:1.2]
set xtics 1
set ytics 1

set lmargin at screen 0.095
set rmargin at screen 0.485
set xlabel "X (m)"
set ylabel "Y (m)" offset 1
set label 1 "undeformed: where J < 0" at graph 0, graph 1.05
# J = 0 where (1 - Y^2)^2 = 1 / (4 s X (1 - X^2))
height(X) = (1 - sqrt(1 / (4 * s * X * (1 - X * X))))
edge(X) = X > 0 && X < 1 && height(X) >= 0 ? sqrt(height(X)) : NaN
set samples 601
set object 1 rectangle from -1, -1 to 1, 1 fc rgb "#CFE3F0" fs noborder behind
plot polygons("square", 9, "$1 <= 0") using 1:2 with filledcurves closed \
         fc rgb "#D55E00", \
     edges("square", 9) using 1:2 with lines lw 0.5 \
         lc rgb "#0072B2", \
     edge(x) with lines lw 2 dt 2 lc rgb "black", \
     -edge(x) with lines lw 2 dt 2 lc rgb "black"

unset object 1
set lmargin at screen 0.6
set rmargin at screen 0.99
set xlabel "x (m)"
set ylabel "y (m)" offset 1
set label 1 "pushed: inverted triangles" at graph 0, graph 1.05
plot polygons("square", 3, "$1 > 0") using 1:2 with filledcurves closed \
         fc rgb "#CFE3F0", \
     polygons("square", 3, "$1 <= 0") using 1:2 with filledcurves closed \
         fs solid fc rgb "#D55E00", \
     edges("square", 3) using 1:2 with lines lw 0.5 \
         lc rgb "#0072B2"

set tmargin at screen 0.46
set bmargin at screen 0.12
set lmargin at screen 0.3475
set rmargin at screen 0.7375
set xrange [-1.45:1.45]
set yrange [-0.4:2.5]
set xlabel "x (m)"
set ylabel "y (m)" offset 1
set label 1 "J > 0, and covered twice" at graph 0, graph 1.05
plot polygons("strip", 3, "$1 > 0 && $2 <= 1") using 1:2 with filledcurves closed \
         fc rgb "#CFE3F0", \
     polygons("strip", 3, "$2 > 1") using 1:2 with filledcurves closed \
         fc rgb "#CC79A7", \
     edges("strip", 3) using 1:2 with lines lw 0.4 \
         lc rgb "#0072B2"
unset multiplot
