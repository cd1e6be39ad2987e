# style.gp - one look for every figure.  Load it before `set output`.
# No `reset session` here: it would erase variables given with gnuplot -e.
set encoding utf8
set terminal svg size 640,420 enhanced font "Helvetica,13" \
    background rgb "white"

# Okabe-Ito colours, distinct for colour-blind readers; every series also has
# its own point or dash type, so a black-and-white print still reads.
set style line 1 lc rgb "#0072B2" lw 2 pt 7 ps 0.6     # computed, first
set style line 2 lc rgb "#D55E00" lw 2 pt 5 ps 0.6     # computed, second
set style line 3 lc rgb "#009E73" lw 2 pt 9 ps 0.7     # computed, third
set style line 4 lc rgb "#CC79A7" lw 2 pt 13 ps 0.7    # computed, fourth
set style line 5 lc rgb "#E69F00" lw 2 pt 11 ps 0.7    # computed, fifth
set style line 6 lc rgb "#56B4E9" lw 2 pt 6 ps 0.8     # computed, sixth
set style line 8 lc rgb "#000000" lw 1 dt 2            # exact or expected
set style line 9 lc rgb "#999999" lw 0.5               # axes and grid

# One colour per meaning, wherever these are told apart:
#   log law 1, cubic law 2, linear law 8; other laws 3, 4, 5, 6
#   banded 1, dense 2, sparse 3; CG with Jacobi 5, incomplete 4, V-cycle 6
#   backward Euler 1, symplectic Euler 2, midpoint 3, BDF2 4
#   projection on demand 3, always 4; PIC 1, FLIP 2, APIC 3

set border 3 back ls 9
set tics nomirror textcolor rgb "black"
set grid back ls 9
set key above left vertical maxrows 3 reverse Left     # never over data
set datafile columnheaders                             # columns by name
set datafile separator "\t"

# A GIF has letters of its own; a scalable font is better where there is one.
scalable = system("fc-match -f '%{file}' sans 2>/dev/null")
gif_font = scalable eq "" ? "giant" : "font '".scalable.",12'"

# The machine that a table with seconds names in its note, and the library that
# took part as LAPACK ("openblas"; plain "lapack" is the reference one).
lapack(file) = system("sed -n 's/^#.*LAPACK: -l//p' '".file."' | head -n 1")
machine(file) = system("sed -n 's/^# machine: //p' '".file."' | head -n 1")
