# error.gp - what an error costs: what halving h still changes in u, against flops
# per step, by multigrid (counted: marks) and by dissection, in the first six steps.
# Expected: they cross at n = 48, and dissection falls more slowly.
# Reads   data  table runs of many.tsv
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,420
set output out
set datafile missing NaN
unset key
# As the chapter has it: 8.9e-5 m at n = 64 (figures/speed/step.c), and n^-1.6;
# flops per unknown of dissection 78 n, of multigrid 3700, here as counted.
error(n) = 8.9e-5 * (n / 64.0) ** -1.6
mflop(n, each) = 2e-6 * n * n * each
counted(x) = strcol("method") eq "geometric" && column("processes") == 1 && \
    column("steps") == 6 && column("n") != 192 ? column("n") : NaN
array Direct[4] = [64, 128, 256, 512]
set margins screen 0.15, screen 0.97, screen 0.16, screen 0.97
set logscale xy
set grid noxtics
set format x "10^{%T}"
set format y "10^{%T}"
set xrange [3:8e4]
set yrange [1.5e-6:5e-4]
set xlabel "Mflop per step"
set ylabel "change of u when h is halved, rms (m)" offset 1
set label 1 "multigrid" at 60,1.3e-5 right tc rgb "#22739F"
set label 2 "dissection" at 4500,1.9e-5 left tc ls 3
set label 3 "n = 48" at mflop(48, 3700) * 1.3,error(48) * 1.2 left
set label 4 "dashed: extrapolated" at 4e4,3e-4 right
do for [k = 1:4] { set label 4 + k sprintf(k == 1 ? "n = %d" : "%d", Direct[k]) \
    at mflop(Direct[k], 78 * Direct[k]) * 1.15,error(Direct[k]) * 1.28 left tc ls 3 }
set parametric
set trange [24:512]
set samples 200
set style line 21 lc rgb "#56B4E9" lw 2 dt 2
set style line 22 lc rgb "#009E73" lw 2 dt 2
plot [t = 24:512] data index "runs" \
         using (mflop(counted(0), column("flops"))):(error(counted(0))) \
         with points ls 6, \
     for [k = 1:4] "+" using (mflop(Direct[k], 78 * Direct[k])):(error(Direct[k])) \
         with points ls 3, \
     mflop(t < 65 ? t : NaN, 3700), error(t) with lines ls 6 dt 1, \
     mflop(t > 64 ? t : NaN, 3700), error(t) with lines ls 21, \
     mflop(t < 65 ? t : NaN, 78 * t), error(t) with lines ls 3 dt 1, \
     mflop(t > 64 ? t : NaN, 78 * t), error(t) with lines ls 22, \
     "+" using (mflop(48, 3700)):(error(48)) with points pt 6 ps 1.8 lc rgb "black"
