# Plots the reachable tool positions of a robot with one axis, along the base frame's x and z: a line.
#   build/bin/conveyor_edp workspace --points 2000 > points.txt
#   gnuplot -c docs/reference/robots/line_workspace.gp points.txt docs/reference/robots/conveyor_workspace.png "the mark on the belt"
set terminal pngcairo size 1000,260 font "sans,10"
set output ARG2
set grid lc rgb "#dddddd"
set xlabel "x, m"
set ylabel "z, m"
set key outside bottom center horizontal
set offsets graph 0.05, graph 0.05, 0.02, 0.02
stats ARG1 using 1 nooutput
set label 1 sprintf("%.4g m", STATS_min) at STATS_min, graph 0.75 center
set label 2 sprintf("%.4g m", STATS_max) at STATS_max, graph 0.75 center
plot ARG1 using 1:3 with points pt 7 ps 0.5 lc rgb "#d9600f" title ARG3, \
     "<echo 0 0" using 1:2 with points pt 2 ps 1.5 lc rgb "#444444" title "base frame"
