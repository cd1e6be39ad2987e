# pattern.gp - two orders of the same vertices, and where L has entries.
# Reads   data  tables grid (i j place depth), rows and dissection (row column
#               what), counts
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 900,370
set output out
blocks(k) = system(sprintf("awk -F'\t' '/^# counts/ { on = NR } \
    on && NR == on + 2 + %d { print $2 \" blocks, \" $3 \" of them fill\" }' \
    '%s'", k, data))
set palette defined (0 "#D55E00", 1 "#E69F00", 2 "#CC79A7", 3 "#009E73", \
                     4 "#0072B2", 5 "#56B4E9", 6 "#999999")
set cbrange [0:6]
unset colorbox
unset grid
unset border
unset tics
unset key
set size ratio -1
set multiplot layout 1,3 margins 0.01,0.99,0.05,0.83 spacing 0.02,0
set title "Dissection: the place of every vertex,\none colour for each depth of cut"
set xrange [0.3:11.7]
set yrange [-0.7:12.7]
plot data index "grid" using "i":"j":"depth" with points pt 7 ps 1.75 \
         lc palette, \
     data index "grid" using "i":"j":(sprintf("%d", column("place"))) \
         with labels font ",8" tc rgb "white"
set border 15 ls 9
set xrange [-3:145]
set yrange [145:-3]
kind(w) = strcol("what") eq w ? column("row") : NaN
set title "L, numbered row by row:\n".blocks(0)
plot data index "rows" using "column":(kind("fill")) with points pt 7 ps 0.13 \
         lc rgb "#D55E00", \
     data index "rows" using "column":(kind("entry")) with points pt 7 ps 0.22 \
         lc rgb "#0072B2"
set title "L, numbered by dissection:\n".blocks(1)
plot data index "dissection" using "column":(kind("fill")) with points pt 7 \
         ps 0.13 lc rgb "#D55E00", \
     data index "dissection" using "column":(kind("entry")) with points pt 7 \
         ps 0.22 lc rgb "#0072B2"
unset multiplot
