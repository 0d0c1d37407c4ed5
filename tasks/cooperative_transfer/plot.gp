# Plots the data of cooperative_transfer_report: gnuplot -e "data='...'; picture='...'" plot.gp
set terminal pngcairo size 1300,820 font 'sans,12'
set output picture
set multiplot layout 2,1
set grid
set key top right
set lmargin 10
set rmargin 10
set xrange [0:*]
set xlabel 'time since the bar is gripped (s)'
set title 'cooperative\_transfer: how far the bar is off its path'
set ylabel 'position (mm)'
set y2label 'orientation (degrees)'
set ytics nomirror
set y2tics
set yrange [0:1]
set y2range [0:0.25]
plot data using 1:2 with lines linewidth 1.5 linecolor rgb '#1f6fb4' title 'position', \
     data using 1:3 axes x1y2 with lines linewidth 1.5 linecolor rgb '#d98c2b' title 'orientation'
set title 'what the arms do against each other, and what they bear together'
set ylabel 'internal force (N)'
set y2label 'weight (N)'
set yrange [0:15]
set y2range [-5:25]
plot data using 1:4 with lines linewidth 1.5 linecolor rgb '#1f6fb4' title 'internal force', \
     data using 1:11 axes x1y2 with lines linewidth 1 linecolor rgb '#7d8a2e' title 'weight'
