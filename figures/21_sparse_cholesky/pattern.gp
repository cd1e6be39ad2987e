# pattern.gp - two orders of the same vertices, and where L has entries.
# Reads   data  tables grid (i j place depth), rows and dissection (row column
#               what), counts
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,1000
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
set multiplot
# The lines of the fifth cut; the other vertices of this depth are pieces.
line(depth, j) = depth < 4 || (depth == 4 && (j == 1 || j == 8))
ink(depth, j) = depth == 1 || depth == 2 || !line(depth, j) ? 0x000000 : 0xFFFFFF
set title "Dissection: the place of every vertex;\nlines in the colour of their cut, pieces white"
set margins screen 0.03, screen 0.87, screen 0.37, screen 0.945
set xrange [0.3:11.7]
set yrange [-0.7:12.7]
set label 1 "1st cut" at 11.7, 6 tc rgb "#D55E00"
set label 2 "2nd" at 6, -0.95 center tc rgb "#E69F00"
set label 3 "3rd cut" at 11.7, 3 tc rgb "#CC79A7"
set label 4 "4th" at 9, -0.95 center tc rgb "#009E73"
set label 5 "5th cut" at 11.7, 1 tc rgb "#0072B2"
plot data index "grid" using (line(column("depth"), column("j")) ? column("i") : NaN):"j":"depth" \
         with points pt 7 ps 3.1 lc palette, \
     data index "grid" using (line(column("depth"), column("j")) ? NaN : column("i")):"j" \
         with points pt 6 ps 3 lw 1.2 lc rgb "#999999", \
     data index "grid" using "i":"j":(sprintf("%d", column("place"))): \
         (ink(column("depth"), column("j"))) with labels font ",12" tc rgb variable
unset label
set border 15 ls 9
set xrange [-3:145]
set yrange [145:-3]
# Column, first and last row of what stands below each other.
runs(table, what) = sprintf("< awk -F'\t' '$0 == \"# %s\" { on = 1 } \
    NF == 0 { on = 0 } on && $3 == \"%s\" { print $2, $1 }' '%s' | \
    sort -n -k 1,1 -k 2,2 | awk 'function end() { if (NR > 1) \
        print column, first, last } \
    $1 != column || $2 != last + 1 { end(); column = $1; first = $2 } \
    { last = $2 } END { end() }'", table, what, data)
set style fill solid noborder
set datafile separator whitespace
set datafile nocolumnheaders
set margins screen 0.01, screen 0.485, screen 0.01, screen 0.285
set title "L, numbered row by row:\n".blocks(0)
plot for [k = 1:2] runs("rows", word("fill entry", k)) \
         using 1:(0.5*($2 + $3)):(0.4):(0.5*($3 - $2) + 0.4) with boxxy \
         lc rgb word("#D55E00 #555555", k)
set margins screen 0.515, screen 0.99, screen 0.01, screen 0.285
set title "L, numbered by dissection:\n".blocks(1)
plot for [k = 1:2] runs("dissection", word("fill entry", k)) \
         using 1:(0.5*($2 + $3)):(0.4):(0.5*($3 - $2) + 0.4) with boxxy \
         lc rgb word("#D55E00 #555555", k)
unset multiplot
