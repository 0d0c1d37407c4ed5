"""Reads the recording of the task follow, prints force, error and speed along the workpiece, and plots them with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT.dat, OUT.txt (the tick in the middle of the path) and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
DESIRED = 10.0  # N


def read_way(path):
    """One (tick, y, z, force) per step of the last ForceControl, which goes along the workpiece."""
    way, last = [], None
    for step in mrroc_trace.steps(path):
        if step.move != "ForceControl":
            continue
        if step.instruction != last:
            way, last = [], step.instruction
        arm = step.robots["arm"]
        way.append((arm.tick, arm.pose[1], arm.pose[2], -arm.wrench[2]))
    return way


def main():
    recording, out = sys.argv[1:3]
    way = read_way(recording)
    with open(out + ".dat", "w", encoding="ascii") as data:
        for _, y, z, force in way:
            data.write(f"{1000 * y} {force} {1000 * (z - way[0][2])}\n")
    with open(out + ".txt", "w", encoding="ascii") as figures:
        figures.write(f"{way[len(way) // 2][0]}\n")
    error = math.sqrt(sum((force - DESIRED) ** 2 for *_, force in way) / len(way))
    length = sum(math.hypot(b[1] - a[1], b[2] - a[2]) for a, b in zip(way, way[1:]))
    speed = length / ((way[-1][0] - way[0][0]) * SERVO_PERIOD)
    print(f"force {DESIRED:.0f} N, error {error:.2f} N RMS, {max(abs(w[3] - DESIRED) for w in way):.2f} N at most, "
          f"over {1000 * length:.0f} mm at {1000 * speed:.1f} mm/s")
    script = f"""
set terminal pngcairo size 1100,620 font 'sans,12'
set output '{out}.png'
set title 'follow: force across, height along a curved workpiece'
set xlabel 'way along the workpiece, y (mm)'
set ylabel 'force (N)'
set y2label 'height of the tool above its start (mm)'
set yrange [0:14]
set ytics nomirror
set y2tics
set grid
set key bottom center
set object rectangle from graph 0, first 9 to graph 1, first 11 fillcolor rgb '#dddddd' fillstyle solid noborder behind
plot '{out}.dat' using 1:2 with lines linewidth 2 linecolor '#0072bd' title 'force', \\
     '' using 1:3 axes x1y2 with lines linewidth 2 linecolor '#d95319' title 'height'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
