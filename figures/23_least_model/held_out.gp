# held_out.gp - estimate against error of all rungs of random scenes, and of those
# that were accepted for 10, 3 and 1 %.
# Reads   data  table rungs (error estimate, ten three one: how it was accepted)
# Writes  out   SVG
if (!exists("data")) data = "build/data/23_least_model/held_out.tsv"
if (!exists("out"))  out  = "figures/23_least_model/held_out.svg"
load "figures/style.gp"
set terminal svg size 600,480
set output out
set logscale xy
set xrange [0.02:300]
set yrange [0.02:300]
set xlabel "true error of the displacement (%)"
set ylabel "estimated error (%)"
set format xy "%g"
set key inside top left vertical maxrows 5 reverse Left samplen 1 nobox
is(h) = strcol("ten") eq h || strcol("three") eq h || strcol("one") eq h ? \
        column("estimate") : NaN
set arrow 1 from 0.02, 10 to 20, 10 nohead ls 9 lw 1.5
set arrow 2 from 0.02, 3 to 6, 3 nohead ls 9 lw 1.5
set arrow 3 from 0.02, 1 to 2, 1 nohead ls 9 lw 1.5
set arrow 4 from 20, 10 to 20, 0.02 nohead lc rgb "#D55E00" dt 3
set arrow 5 from 6, 3 to 6, 0.02 nohead lc rgb "#D55E00" dt 3
set arrow 6 from 2, 1 to 2, 0.02 nohead lc rgb "#D55E00" dt 3
set style textbox opaque noborder margins 0.2, 0.2
set label 1 "2 %" at 2.15, 0.03 textcolor rgb "#D55E00" boxed
set label 2 "6 %" at 6.4, 0.03 textcolor rgb "#D55E00" boxed
set label 3 "20 %" at 21.5, 0.03 textcolor rgb "#D55E00" boxed
set label 4 "none is wrong by\nmore than twice\nits tolerance" at 24, 0.5 textcolor rgb "#D55E00" boxed
plot data index "rungs" using "error":"estimate" with points pt 7 ps 0.35 lc rgb "#BBBBBB" \
         title "a rung", \
     x with lines ls 8 notitle, \
     data index "rungs" using "error":(is("right")) with points ls 1 ps 0.8 \
         title "accepted, and no lower rung would do", \
     "" index "rungs" using "error":(is("lower")) with points pt 13 ps 0.9 \
         lc rgb "#E69F00" title "accepted, but a lower rung would do", \
     "" index "rungs" using "error":(is("above")) with points pt 8 ps 0.9 lw 2 \
         lc rgb "#CC79A7" title "accepted, but it misses the tolerance", \
     "" index "rungs" using "error":(is("wrong")) with points pt 2 ps 1.6 lw 3 \
         lc rgb "#D55E00" notitle
