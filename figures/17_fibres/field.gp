# field.gp - a block with bent fibres: at rest, activated between two held ends,
# and activated with one end held; coloured by the stretch of the fibres.
# Reads   data  tables fibres, outline, history
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 640,720 enhanced font "Helvetica,20" \
    background rgb "white"
set output out
set multiplot
unset key
unset grid
unset border
unset tics
set size ratio -1
set datafile nocolumnheaders
set xrange [-1.1:1.1]
set yrange [-0.78:0.60]
set palette defined (0.76 "#0072B2", 0.9 "#8AB9DA", 1.0 "#BBBBBB", 1.08 "#D55E00")
set cbrange [0.76:1.08]
unset colorbox
of(table, block) = sprintf( \
    "< awk -F'\t' '$0 == \"# %s\" { on = 1; next } NF == 0 { on = 0 } \
     on && $1 == \"%s\"' '%s'", table, block, data)
last(block, field) = system(sprintf( \
    "awk -F'\t' '$0 == \"# history\" { on = 1; next } NF == 0 { on = 0 } \
     on && $1 == \"%s\" { v = $%d } END { print v }' '%s'", block, field, data)) + 0.0
first(field) = system(sprintf( \
    "awk -F'\t' '$0 == \"# history\" { on = 1; next } NF == 0 { on = 0 } \
     on && $2 == \"0\" && !n++ { print $%d }' '%s'", field, data)) + 0.0
array Block[3] = ["rest", "both", "left"]
array Title[3] = ["at rest", "activated,\nboth ends held", "activated,\nleft end held"]
array Says[3]
Says[1] = sprintf("%.1f° to the axis", first(3))
Says[2] = sprintf("%.1f° to the axis,\npulls with %.0f N/m", last("both", 3), last("both", 4))
Says[3] = sprintf("%.1f° to the axis,\n%.0f %% shorter", last("left", 3), -last("left", 5) / 2 * 100)
set lmargin at screen 0.005
set rmargin at screen 0.60
h = 0.055 # half of a piece at rest (m)
do for [i = 1:3] {
    top = 0.995 - 0.29 * (i - 1)
    set tmargin at screen top
    set bmargin at screen top - 0.285
    set label 1 Title[i]."\n".Says[i] at screen 0.56, screen top - 0.08
    if (i > 1) { set arrow 1 from -1, -0.56 to -1, 0.56 nohead lw 4 }
    if (i == 2) { set arrow 2 from 1, -0.56 to 1, 0.56 nohead lw 4 }
    else { unset arrow 2 }
    if (i == 3) {
        set colorbox user horizontal origin screen 0.44, screen 0.075 \
            size screen 0.50, screen 0.025
        set cbtics 0.1 scale 0.4 textcolor rgb "black" offset 0, 0.4
        set label 3 "stretch l of the fibres" at screen 0.41, screen 0.087 right
    }
    plot of("outline", Block[i]) using 2:3 with filledcurves closed fc rgb "#F4EDE4", \
         of("outline", Block[i]) using 2:3 with lines lw 1 lc rgb "#999999", \
         of("fibres", Block[i]) using ($2 - h * $4):($3 - h * $5):(2 * h * $4):(2 * h * $5):6 \
             with vectors nohead lw 2.4 lc palette
}
unset multiplot
