# cut.gp - a strip of tissue at full pull, whole and cut, with the force in the
# hand to scale; and the force against the pull: between the two curves lies the
# energy that the cut releases.
# Reads   data  tables pull, cut, cells
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,680 font "Helvetica,14"
set output out
cut(column) = system(sprintf("awk -F'\t' '$0 == \"# cut\" { on = 1 } \
    on && $1 ~ /^[0-9]/ { print $%d; exit }' '%s'", column, data)) + 0.0

# From table cells, in mm: the cells between the rows `first` and `last`, each
# run of neighbours once around; and all cells, each once around.
rows(strip, first, last) = sprintf("< awk -F'\t' 'function end() { \
        for (i = 1; i <= n; i++) print low[i]; \
        for (i = n; i >= 1; i--) print high[i]; if (n) print \"\"; n = 0 } \
    $1 == \"%s\" && NF == 9 { cell++; row = int((cell - 1) / 40) + 1; \
        if ($2 \" \" $3 != low_right || $8 \" \" $9 != high_right) end(); \
        low_right = $4 \" \" $5; high_right = $6 \" \" $7; \
        if (row >= %d && row <= %d) { if (!n) { \
            low[++n] = 1e-3 * $2 \" \" 1e-3 * $3; \
            high[n] = 1e-3 * $8 \" \" 1e-3 * $9 } \
        low[++n] = 1e-3 * $4 \" \" 1e-3 * $5; \
        high[n] = 1e-3 * $6 \" \" 1e-3 * $7 } } END { end() }' '%s'", \
    strip, first, last, data)
edges(strip) = sprintf("< awk -F'\t' '$1 == \"%s\" && NF == 9 { \
        for (i = 2; i < 9; i += 2) print 1e-3 * $i, 1e-3 * $(i + 1); \
        print 1e-3 * $2, 1e-3 * $3; print \"\" }' '%s'", strip, data)

array Strip[2] = ["whole", "cut"]
set style fill solid noborder
set multiplot
unset key
unset border
unset tics
unset grid
set size ratio -1
set xrange [-56:88]
set yrange [-18.5:21]
set lmargin at screen 0.01
set rmargin at screen 0.99
do for [k = 1:2] {
    set tmargin at screen k == 1 ? 0.985 : 0.745
    set bmargin at screen k == 1 ? 0.755 : 0.515
    F = cut(k)
    set object 1 rectangle from -55, -16 to -50, 16 fc rgb "#EFE9DA" \
        fs solid noborder behind
    set arrow 1 from 65.5, 0 rto 450*F, 0 size 2, 20 filled front lw 2.5 \
        lc rgb "#D55E00"
    set label 1 sprintf("%.4f N", F) at 66, 4.5 left tc rgb "#D55E00"
    set label 2 k == 1 ? "whole" : "cut" at -49, 18 left
    if (k == 2) {
        set label 3 sprintf("%.1f mm", 1e3 * cut(3)) at 7, 19.6 center
    }
    set datafile nocolumnheaders
    set datafile separator whitespace
    plot rows(Strip[k], 1, 8) with filledcurves closed fc rgb "#B3473F", \
         rows(Strip[k], 9, 10) with filledcurves closed fc rgb "#F3D07A", \
         rows(Strip[k], 11, 12) with filledcurves closed fc rgb "#E3A787", \
         edges(Strip[k]) with lines lw 0.4 lc rgb "#70401000"
    set datafile columnheaders
    set datafile separator "\t"
}
unset object
unset arrow
unset label
set size noratio
set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid back ls 9
set lmargin at screen 0.13
set rmargin at screen 0.97
set tmargin at screen 0.46
set bmargin at screen 0.105
set xrange [0:15.5]
set yrange [0:50]
set xlabel "pull (mm)"
set ylabel "force in the hand (mN)"
set style textbox opaque noborder margins 0.2, 0.2
set label 1 "whole" at 9.2, 34.5 right tc ls 1 boxed
set label 2 "cut" at 12.6, 25.5 left tc ls 2 boxed
set label 3 sprintf("shaded: %.1f µJ, released by the cut", 1e6 * cut(6)) \
    at 15.2, 5 right boxed
plot data index "pull" using (1e3*column("d")):(1e3*column("whole")):\
         (1e3*column("cut")) with filledcurves fc rgb "#F6DDC9", \
     "" index "pull" using (1e3*column("d")):(1e3*column("whole")) \
         with linespoints ls 1, \
     "" index "pull" using (1e3*column("d")):(1e3*column("cut")) \
         with linespoints ls 2
unset multiplot
