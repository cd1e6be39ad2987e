# cost.gp - the error of two laws after each linear solve, against the log law's
# answer: the first solve is that of the linear law, whatever the law.
# Reads   data  table cost
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 760,420 enhanced font "Helvetica,16"
set output out
set multiplot layout 1,2
set lmargin 9; set rmargin 2; set tmargin 2.2; set bmargin 3.6
set logscale y
set xrange [0.6:6.4]
set yrange [1e-10:3]
set format y "10^{%T}"
set xtics 1
set xlabel "linear solves"
unset key
of(F, law, y) = \
    column("F") == F && strcol("law") eq law ? column(y) : 1/0
array F[2] = [0.95, 0.8]
array Name[2] = ["5 % shorter", "20 % shorter"]
# to leading order the laws differ by mu (F-1)^3, of (2 mu + lambda)(F-1)
ratio = (1 - 2*0.3) / (2 - 2*0.3) # mu / (2 mu + lambda), nu = 0.3
do for [k = 1:2] {
    first = k == 1
    stats data index "cost" using (column("solves") == 1 ? \
        of(F[k], "log", "error") : 1/0) nooutput name "L"
    predicted = ratio * (F[k] - 1)**2
    set ylabel first ? "error of the strain, relative" : ""
    set title Name[k] offset 0,-0.5
    set label 2 "the linear law's answer" at 1.3,L_max*2.2 left boxed
    set label 3 "cubic law" at 6.3,predicted*4.5 right textcolor rgb "#D55E00" boxed
    set label 4 "dashed: predicted,\nμ(F-1)²/(2μ+λ)" at 6.3,predicted/6 right boxed
    set label 5 "log law" at 1.55 + 0.87*k,1e-7 right textcolor rgb "#0072B2" boxed
    plot data index "cost" using "solves":(of(F[k], "log", "error")) \
             with linespoints ls 1, \
         "" index "cost" using "solves":(of(F[k], "cubic", "error")) \
             with linespoints ls 2, \
         predicted with lines ls 8
}
unset multiplot
