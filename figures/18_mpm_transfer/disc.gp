# disc.gp - velocities of a disc after a hundred transfers, four ways.
# Reads   data  tables disc, left
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 620,600 enhanced font "Helvetica,15" \
    background rgb "white"
set output out
array Way[4] = ["FLIP", "APIC", "PIC", "95 % FLIP"]
left(way) = real(system(sprintf("awk -F'\t' '/^# left/ { on = 1 } \
    on && $1 == \"%s\" { print $2; exit }' '%s'", way, data)))
unset key
unset grid
unset colorbox
set size ratio -1
set xrange [-0.33:0.33]
set yrange [-0.35:0.33]
set border 0
unset tics
set palette defined (0 "#C6DBEF", 0.5 "#4292C6", 1 "#08306B")
set cbrange [0:0.3]
set multiplot
do for [k = 1:4] {
    set lmargin at screen 0.01 + 0.43 * ((k - 1) % 2)
    set rmargin at screen 0.43 + 0.43 * ((k - 1) % 2)
    set tmargin at screen 0.945 - 0.5 * ((k - 1) / 2)
    set bmargin at screen 0.505 - 0.5 * ((k - 1) / 2)
    set label 1 sprintf("%s: %.1f %% of the spin", Way[k], 100 * left(Way[k])) \
        at graph 0.5, graph 1.045 center
    if (k == 4) {
        set colorbox user origin screen 0.89, screen 0.08 \
            size screen 0.02, screen 0.33
        set cbtics 0.1 offset -0.5 textcolor rgb "black"
        set label 5 "speed (m/s)" at screen 0.92, screen 0.035 center }
    # a bar as long as what is left, in a frame that is the whole spin
    set object 2 rectangle from -0.2, -0.335 to 0.2, -0.31 fs empty \
        border lc rgb "#999999"
    set object 3 rectangle from -0.2, -0.335 to -0.2 + 0.4 * left(Way[k]), -0.31 \
        fc rgb "#0072B2" fs solid noborder
    plot data index "disc" using \
        (strcol("way") eq Way[k] ? column("x") - 0.09 * column("v_x") : NaN): \
        (column("y") - 0.09 * column("v_y")): \
        (0.18 * column("v_x")):(0.18 * column("v_y")):"speed" \
        with vectors head size 0.012,22 filled lw 1.4 lc palette
}
unset multiplot
