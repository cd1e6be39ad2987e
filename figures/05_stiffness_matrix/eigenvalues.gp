# eigenvalues.gp - the spectrum of A on equal elements: the formula, GSL, and
# what -u'' has.
#
# Reads   data  tables eigenvalues_none, eigenvalues_one,
#               eigenvalues_both (k exact gsl continuum)
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 760,430 enhanced font "Helvetica,13" \
    background rgb "white"
set output out

both = "eigenvalues_both"
one = "eigenvalues_one"
none = "eigenvalues_none"
stats data index none using "k" nooutput
n = STATS_max - 1.0

set multiplot
set key at screen 0.02, screen 0.985 left top vertical maxrows 3 reverse Left
set tmargin at screen 0.78
set bmargin at screen 0.14
set lmargin at screen 0.09
set rmargin at screen 0.50
set xlabel "number k of the eigenvalue"
set ylabel "λ_k h/4" offset 0.5
set xrange [0.5:n + 1.5]
set yrange [-0.02:1.02]
h4 = 1.0 / (4 * n)
plot data index none using "k":(h4 * column("exact")) with lines ls 1 lw 1 \
         title "no end fixed: formula", \
     data index one using "k":(h4 * column("exact")) with lines ls 2 lw 1 \
         title "one end fixed: formula", \
     data index both using "k":(h4 * column("exact")) with lines ls 3 lw 1 \
         title "both ends fixed: formula", \
     data index none using "k":(h4 * column("gsl")) with points ls 1 ps 0.8 \
         title "GSL", \
     data index one using "k":(h4 * column("gsl")) with points ls 2 ps 0.8 \
         title "GSL", \
     data index both using "k":(h4 * column("gsl")) with points ls 3 ps 0.9 \
         title "GSL"

set key at screen 0.66, screen 0.985 left top vertical maxrows 3 reverse Left
set lmargin at screen 0.59
set rmargin at screen 0.98
set xlabel "k/n, for both ends fixed"
set ylabel "λ_k / h(kπ)^2" offset 0.5
set xrange [0:1]
set yrange [0.38:1.02]
sinc(s) = s == 0 ? 1.0 : (sin(0.5 * pi * s) / (0.5 * pi * s))**2
limit = 4.0 / pi**2
ratio(i) = column("exact") / column("continuum")
plot data index both using (column("k") / n):(ratio(0)) \
         with points ls 3 ps 0.9 title sprintf("A with n = %.0f", n), \
     sinc(x) with lines ls 8 title "(sin t / t)^2, t = kπ/2n", \
     limit with lines ls 9 lw 1.5 dt 4 title sprintf("4/π^2  = %.3f", limit)
unset multiplot
set output
