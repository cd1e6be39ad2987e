# square.gp - the square that its fibres contract, coloured by J, and the fibres,
# wide where their tension is large.
# Reads   data  tables nodes (X Y u_x u_y), field (e angle_now T)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 560,430
set output out
table = "nodes"
load "figures/square.gp"
eval reach(1.1)
set xtics 1
set ytics 1
# a line through the middle of each triangle, as long as the fibre pulls hard
array X[128]
array Y[128]
do for [e = 1:128] { X[e] = NaN; Y[e] = NaN }
stats "< ".ask(data, "middle") using (X[$1 + 1] = $2, Y[$1 + 1] = $3) nooutput
h(T) = 0.08 * (T > 300 ? 1 : T < 0 ? 0 : T / 300)
plot @SQUARE, data index "field" every ::1 \
    using (X[$1 + 1] - h($5) * cos($3)):(Y[$1 + 1] - h($5) * sin($3)): \
          (2 * h($5) * cos($3)):(2 * h($5) * sin($3)) \
    with vectors nohead lw 2 lc rgb "black"
