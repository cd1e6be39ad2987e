# eigenvalues.gp - the spectrum of A on equal elements: the formula, GSL, and
# what -u'' has.
#
# Reads   data  tables eigenvalues_none, eigenvalues_one,
#               eigenvalues_both (k exact gsl continuum)
# Writes  out   SVG
load "figures/style.gp"
set style textbox opaque noborder # labels hide the grid
set terminal svg size 760,400 enhanced font "Helvetica,16" \
    background rgb "white"
set output out

both = "eigenvalues_both"
one = "eigenvalues_one"
none = "eigenvalues_none"
stats data index none using "k" nooutput
n = STATS_max - 1.0

set multiplot
unset key
set label 1 "no end fixed" at 9.2, 0.5 tc ls 1 boxed
set label 2 "one end" at 7.7, 0.4 tc ls 2 offset 0,-0.3 boxed
set label 3 "both ends fixed" at 6.6, 0.75 right tc ls 3 boxed
set label 4 "points: GSL; lines: formula" at 13.2, 0.03 right boxed
set tmargin at screen 0.96
set bmargin at screen 0.19
set lmargin at screen 0.115
set rmargin at screen 0.50
set xlabel "number k of the eigenvalue"
set ylabel "λ_k h/4" offset 0.5
set xrange [0.5:n + 1.5]
set yrange [-0.02:1.02]
h4 = 1.0 / (4 * n)
plot data index none using "k":(h4 * column("exact")) with lines ls 1 lw 1, \
     data index one using "k":(h4 * column("exact")) with lines ls 2 lw 1, \
     data index both using "k":(h4 * column("exact")) with lines ls 3 lw 1, \
     data index none using "k":(h4 * column("gsl")) with points ls 1 ps 0.8, \
     data index one using "k":(h4 * column("gsl")) with points ls 2 ps 0.8, \
     data index both using "k":(h4 * column("gsl")) with points ls 3 ps 0.9

unset label
set lmargin at screen 0.625
set rmargin at screen 0.98
set xlabel "k/n, for both ends fixed"
set ylabel "λ_k /(h(kπ)^2)" offset 1.5
set xrange [0:1]
set yrange [0.38:1.02]
sinc(s) = s == 0 ? 1.0 : (sin(0.5 * pi * s) / (0.5 * pi * s))**2
limit = 4.0 / pi**2
set label 1 sprintf("A with n = %.0f", n) at 0.99, 0.79 right tc ls 3 boxed
set label 2 "dashed:\n(sin t / t)^2, t = kπ/2n" at 0.04, 0.62 boxed
set label 3 sprintf("4/π^2 = %.3f", limit) at 0.04, 0.425 boxed
ratio(i) = column("exact") / column("continuum")
plot data index both using (column("k") / n):(ratio(0)) \
         with points ls 3 ps 0.9, \
     sinc(x) with lines ls 8, \
     limit with lines ls 9 lw 1.5 dt 4
unset multiplot
set output
