# budget.gp - frames that stay unfinished against the systems that a frame may
# solve, by the second rung alone; beside each point how far off the worst of
# them is.  Hollow: both rungs with their 8 systems.
# Reads   data  tables systems, sizes
# Writes  out   SVG
load "figures/style.gp"
set terminal svg size 580,400
set output out
unset key
set logscale x 2
set logscale y
set grid noxtics
set xrange [1.35:40]
set yrange [0.5:500]
set xtics (2, 4, 8, 16, 32)
set xlabel "linear systems that a frame may solve"
set ylabel "frames unfinished, of 300" offset 0.5
set label 1 "cubic law" at 2.9,150 tc ls 2
set label 2 "log law" at 2.6,60 right tc ls 1
set label 3 "none" at 32,0.72 center
set label 4 "numbers: distance of the worst\nfrom convergence (0.03 mm: converged,\nbut not yet known to be)" at 36,330 right tc rgb "#555555"
both(law) = strcol("law") eq law && strcol("fallback") eq "budget" ? \
    column("unfinished") : NaN
off(name) = strcol(name) eq "-" ? "" : column(name) < 1e-3 ? \
    sprintf("%.1g mm", 1e3 * column(name)) : sprintf("%.2g m", column(name))
plot data index "sizes" using "budget":(column("log_late") > 0 ? column("log_late") : NaN) \
         with linespoints ls 1, \
     "" index "sizes" using "budget":(column("cubic_late") > 0 ? column("cubic_late") : NaN) \
         with linespoints ls 2, \
     "" index "sizes" using "budget":"log_late":(off("log_off")) \
         with labels right offset -1,-0.7 tc ls 1, \
     "" index "sizes" using "budget":"cubic_late":(off("cubic_off")) \
         with labels left offset 0,1.2 tc ls 2, \
     "" index "systems" using (8):(both("log")) \
         with points ls 1 pt 6 ps 1.1, \
     "" index "systems" using (8):(both("cubic")) \
         with points ls 2 pt 4 ps 1.1, \
     "" index "systems" using (8):(both("log")):\
         (sprintf("both\nrungs: %d", column("unfinished"))) \
         with labels left offset 1,0.3 tc ls 1, \
     "" index "systems" using (8):(both("cubic")):\
         (sprintf("both rungs: %d", column("unfinished"))) \
         with labels left offset 1.2,0.6 tc ls 2
