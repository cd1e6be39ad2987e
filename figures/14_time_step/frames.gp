# frames.gp - the loop: what every frame of the script took, by the attempt that
# solved it, with the budget of 1/30 s.
# Reads   data  tables frames (t attempts substeps status seconds), script,
#               machine
# Writes  out   SVG
if (!exists("data")) data = "build/data/14_time_step/frames.tsv"
if (!exists("out"))  out  = "figures/14_time_step/frames.svg"
load "figures/style.gp"
set terminal svg size 720,500 enhanced font "Helvetica,16" \
    background rgb "white"
set output out
array Word[8] = ["grab", "pull", "hold", "shake", "slam", "push", "hold", \
                 "let go"]
array Until[8]
do for [m = 1:8] {
    stats data index "script" using "until" every ::m-1::m-1 nooutput
    Until[m] = STATS_max
    set arrow m from Until[m], graph 0 to Until[m], graph 1 nohead ls 9 lw 1
    set label m Word[m] rotate by (m == 1 || m == 5 ? 90 : 0) at (m == 1 ? 0.5 * Until[m] \
        : 0.5 * (Until[m] + Until[m - 1])), graph (m == 1 || m == 5 ? 0.92 : 0.95) \
        center font ",16"
}
stats data index "loop" using "p50" nooutput
p50 = STATS_max * 1e3
stats data index "loop" using "misses" nooutput
misses = STATS_max
stats data index "loop" using "frames" nooutput
frames = STATS_max
stats data index "frames" using "seconds" nooutput
worst = STATS_max * 1e3
stats data index "loop" using "n" nooutput
n = STATS_max
by(a, b) = column("attempts") >= a && column("attempts") <= b \
           && stringcolumn("status") eq "OK" ? column("seconds") * 1e3 : 1/0
slow(x) = column("attempts") >= 3 ? column("seconds") * 1e3 : 0
stats data index "frames" using (slow(0)) nooutput name "PARTS"
lost(x) = stringcolumn("status") ne "OK" ? column("seconds") * 1e3 : 1/0
set label 20 machine(data) at screen 0.99,0.02 right font ",10" \
    textcolor rgb "#555555"
set bmargin 6
set logscale y
set xrange [0:3.4]
set yrange [0.1:1000<*]
unset key
set label 22 "1/30 s" at 0.24, 48
set label 23 "at once (FAST)" at 0.3, 1.6 textcolor ls 1
set label 24 "second\nattempt\n(ROBUST)" at 2.85, 16 textcolor ls 2
slowest(x) = by(3, 9) == PARTS_max ? x : 1/0
set xlabel "time in the script (s)"
set ylabel "time for the frame (ms)"
set label 21 sprintf("n = %d: median %.1f ms; %d of %d frames %s longer than 1/30 s, \
the worst %.0f ms", n, p50, misses, frames, misses == 1 ? "takes" : "take", worst) at screen 0.01,0.07 left font ",15"
plot 1000.0 / 30 with lines ls 8 lw 1.5, \
     data index "frames" using "t":(by(1, 1)) with points ls 1, \
     data index "frames" using "t":(by(2, 2)) with points ls 2, \
     data index "frames" using "t":(by(3, 9)) with points ls 3 ps 0.9, \
     data index "frames" using (slowest(column("t") + 0.05)):(by(3, 9)): \
         ("in parts") with labels left tc ls 3, \
     data index "frames" using "t":(lost(0)) with points ls 4 pt 2 ps 0.9
set output
