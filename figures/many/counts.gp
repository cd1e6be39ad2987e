# counts.gp - what a step costs on several processes, in counts: iterations per
# linear system by three preconditioners, and messages per process and step.
# Expected: geometric multigrid does not grow; messages grow with the levels.
# Reads   data  tables runs, messages of many.tsv
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,760
set output out
set datafile missing NaN
unset key
first_steps(method, p) = strcol("method") eq method && column("steps") == 6 \
        && column("n") != 192 && column("processes") == p ? column("iterations") : NaN
sent(p, what) = strcol("method") eq "geometric" && column("processes") == p \
        && column("n") >= 64 ? column(what) : NaN
set logscale x
set grid noxtics
set xrange [55:590]
set xtics (64, 128, 256, 512)
set xlabel "squares per side n"
set multiplot layout 2,1 margins 0.12,0.97,0.08,0.985 spacing 0,0.10
set yrange [0:20]
set ylabel "iterations per linear system" offset 1
set label 1 "geometric multigrid" at 66,6 tc rgb "#22739F"
set label 2 "algebraic, with rigid motions" at 66,11.9 tc ls 3
set label 3 "algebraic, without rigid motions" at 66,16.6 tc ls 2
set label 4 "one process" at 570,18.8 right
plot data index "runs" using "n":(first_steps("geometric", 1)) \
         with linespoints ls 6, \
     "" index "runs" using "n":(first_steps("rigid_modes", 1)) \
         with linespoints ls 3, \
     "" index "runs" using "n":(first_steps("algebraic", 1)) \
         with linespoints ls 2
unset label 4
set yrange [0:1300]
set ylabel "messages of a process per step" offset 1
set label 1 "four processes" at 66,860 tc rgb "#9C4A78"
set label 2 "two processes" at 66,330 tc rgb "#8F6300"
set label 3 "dashed: theory" at 262,690 tc rgb "black"
plot data index "messages" using "n":(sent(4, "messages")) with points ls 4 ps 1.2, \
     "" index "messages" using "n":(sent(2, "messages")) with points ls 5 ps 1, \
     "" index "messages" using "n":(sent(4, "predicted")) with lines ls 8, \
     "" index "messages" using "n":(sent(2, "predicted")) with lines ls 8
unset multiplot
