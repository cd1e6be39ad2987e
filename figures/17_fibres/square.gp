# square.gp - the square that its fibres contract, and the fibres, long where their
# tension is large and coloured by their stretch.
# Reads   data  tables nodes (X Y u_x u_y), field (e angle_now l T)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,430
set output out
table = "nodes"
load "figures/square.gp"
eval reach(1.1)
set xlabel "x_1  (m)"
set ylabel "x_2  (m)"
set xtics 1
set ytics 1
# the colours of field.gp
set palette maxcolors 0 defined (0.76 "#0072B2", 0.9 "#8AB9DA", 1.0 "#BBBBBB", 1.08 "#D55E00")
set cbrange [0.76:1.08]
set cbtics 0.08
set cblabel "stretch l of the fibres" rotate offset 0.5
# a line through the middle of each triangle, as long as the fibre pulls hard
array X[128]
array Y[128]
do for [e = 1:128] { X[e] = NaN; Y[e] = NaN }
stats "< ".ask(data, "middle") using (X[$1 + 1] = $2, Y[$1 + 1] = $3) nooutput
h(T) = 0.055 * (T > 300 ? 1 : T < 0 ? 0 : T / 300)
plot '< '.ask(data, 'mesh') using 1:2 with lines lw 0.5 lc rgb "#CCCCCC", \
     '< '.ask(reference, 'edge') using 1:2 with lines lw 3 lc rgb '#B0666666', \
     data index "field" every ::1 \
    using (X[$1 + 1] - h($5) * cos($3)):(Y[$1 + 1] - h($5) * sin($3)): \
          (2 * h($5) * cos($3)):(2 * h($5) * sin($3)):4 \
    with vectors nohead lw 2.6 lc palette
