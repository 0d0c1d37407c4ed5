# Plots reachable tool positions (lines of x y z, m, in the base frame) from above and from the side.
#   build/bin/irb6_edp workspace --points 20000 > points.txt
#   gnuplot -c docs/reference/robots/workspace.gp points.txt docs/reference/robots/irb6_workspace.png
# A third argument "x" takes x instead of the distance from the column's axis for the side view (a robot on a track).
set terminal pngcairo size 1000,460 font "sans,10"
set output ARG2
set multiplot layout 1,2
set size ratio -1
set grid lc rgb "#dddddd"
set style data dots
unset key
set xlabel "x, m"
set ylabel "y, m"
plot ARG1 using 1:2 lc rgb "#d9600f"
set ylabel "z, m"
if (ARG3 eq "x") {
  set xlabel "x, m"
  plot ARG1 using 1:3 lc rgb "#d9600f"
} else {
  set xlabel "distance from the column's axis, m"
  plot ARG1 using (sqrt($1**2 + $2**2)):3 lc rgb "#d9600f"
}
