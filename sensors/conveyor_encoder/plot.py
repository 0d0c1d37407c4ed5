"""Reads the trace of this folder's demo and plots both encoders' positions and the belt's velocity with gnuplot.

Usage: plot.py TRACE OUT    writes OUT.dat and OUT.png
"""

import re
import subprocess
import sys

SERVO_PERIOD = 0.002  # s, the deployment's


def values(line, sensor):
    """(tick, position, velocity) of a sensor in one line of the trace."""
    tick, position, velocity = re.search(rf" sensor={sensor} tick=(\d+) values=([^ ,]+),([^ \n]+)", line).groups()
    return int(tick), float(position), float(velocity)


def main():
    trace, out = sys.argv[1:3]
    with open(trace, encoding="ascii") as lines:
        steps = [(values(line, "fine"), values(line, "coarse")) for line in lines if " sensor=fine" in line]
    with open(out + ".dat", "w", encoding="ascii") as data:
        for fine, coarse in steps:
            data.write(f"{fine[0] * SERVO_PERIOD} {fine[1]} {coarse[1]} {fine[2]}\n")
    script = f"""
set terminal pngcairo size 900,420 font 'sans,11'
set output '{out}.png'
set title 'conveyor\\_encoder: a belt that another program drives'
set xlabel 'time (s)'
set ylabel 'position (m)'
set y2label 'velocity (m/s)'
set ytics nomirror
set y2tics
set grid
set key top left
plot '{out}.dat' using 1:2 with lines linewidth 2 linecolor '#0072bd' title 'position', \\
     '{out}.dat' using 1:3 with steps linewidth 2 linecolor '#d95319' title 'position by steps of 0.05 m', \\
     '{out}.dat' using 1:4 axes x1y2 with lines linewidth 1 linecolor '#77ac30' title 'velocity'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
    worst = max(abs(fine[1] - coarse[1]) for fine, coarse in steps)
    print(f"{len(steps)} steps, the belt at {steps[-1][0][1]:.4f} m, the coarse encoder off by at most {worst:.4f} m")


if __name__ == "__main__":
    main()
