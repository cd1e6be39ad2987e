# square.gp - the deformed mesh of a table of `data`, coloured by J.  After
# style.gp, and with the name of the table:
#
#     table = "nodes"            a table that square.awk knows
#     load "figures/square.gp"
#     eval reach(1.2)            both ranges, wide enough; the title says what is odd
#     plot @SQUARE
#
# k: "", or of a table with a column k the rows with this one.  The grey outline is
# that of the data file `reference`, where one is given.
if (!exists("reference")) reference = data
if (!exists("k")) k = ""
ask(file, what) = sprintf("awk -v table='%s' -v k='%s' -v what='%s' -f \
figures/square.awk '%s'", table, k, what, file)
wide(file) = real(system(ask(file, "reach")))
R = 1
reach(least) = sprintf("R = %g; set xrange [-R:R]; set yrange [-R:R]; \
set title '%s'", wide(data) > least ? 1.04 * wide(data) : least, \
    system(ask(data, "said")))
SQUARE = "for [c in system(ask(data, 'classes'))] '< '.ask(data, c) using 1:2 \
with filledcurves closed fc palette cb 0.1 * int(c), \
'< '.ask(data, 'mesh') using 1:2 with lines lw 0.6 lc rgb '#333333', \
'< '.ask(reference, 'edge') using 1:2 with lines lw 3 \
lc rgb '#B0666666'"
set datafile nocolumnheaders
unset key
unset grid
set size ratio -1
set style fill solid 1 noborder
# one colour for J <= 0, blue for what is pressed, orange for what is stretched
set palette maxcolors 21 defined (0 "#D600BE", 0.03 "#D600BE", 0.031 "#08306B", \
    0.3 "#0072B2", 0.5 "#F4F4F4", 0.7 "#E8853A", 1 "#8A3000")
set cbrange [-0.05:2.05]
set cbtics ("≤ 0" 0, 0.5, 1, 1.5, "≥ 2" 2) scale 0.3
set cblabel "J" rotate by 0 offset -1
