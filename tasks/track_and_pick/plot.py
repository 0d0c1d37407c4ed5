"""Reads the recording of the task track_and_pick, prints the figures of each pick, and plots them with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT_track.dat, OUT.txt (a tick at which a part is gripped) and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's


def read_parts(path):
    """Per part the (tick, x, y, z of the tool in m, belt in m) of the steps from the catch-up to the lift."""
    parts, previous = [], ""
    for step in mrroc_trace.steps(path):
        if step.process != "mp":
            continue
        if step.move is None or "TrackFrame" not in step.move:
            previous = ""
            continue
        if not previous.startswith("TrackFrame"):
            parts.append({"steps": [], "gripped": None, "grip": ""})
        previous = step.move
        arm = step.robots["arm"]
        parts[-1]["steps"].append((arm.tick, *arm.pose[:3], step.sensors["encoder"].values[0]))
        if previous.startswith("TrackFrame +"):
            parts[-1]["gripped"] = arm.tick
    return [part for part in parts if part["gripped"]]


def main():
    recording, out = sys.argv[1:3]
    parts = read_parts(recording)
    worst = 0.0
    with open(out + "_track.dat", "w", encoding="ascii") as track:
        for number, part in enumerate(parts, 1):
            at = next(step for step in part["steps"] if step[0] == part["gripped"])
            for tick, x, y, z, belt in part["steps"]:
                along = 1000 * ((y - belt) - (at[2] - at[4]))
                track.write(f"{(tick - at[0]) * SERVO_PERIOD} {along} {1000 * (x - at[1])} {1000 * (z - at[3])}\n")
                if -1 <= (tick - at[0]) * SERVO_PERIOD <= 0:
                    worst = max(worst, math.hypot(along, 1000 * (x - at[1])))
            track.write("\n\n")
    print(f"{len(parts)} parts picked; in the second before the grip the tool kept its position on the belt within {worst:.2f} mm")
    with open(out + ".txt", "w", encoding="ascii") as figures:
        figures.write(f"{parts[len(parts) // 2]['gripped']}\n")
    script = f"""
set terminal pngcairo size 1300,620 font 'sans,12'
set output '{out}.png'
set multiplot layout 1,2
set grid
set key off
set title 'track\\_and\\_pick: way of the tool as seen from the belt'
set xlabel 'time to the grip (s)'
set ylabel 'along the belt (mm), height above the grip (mm)'
plot for [i=0:{len(parts) - 1}] '{out}_track.dat' index i using 1:2 with lines linewidth 1.5 linecolor rgb '#1f6fb4', \\
     for [i=0:{len(parts) - 1}] '{out}_track.dat' index i using 1:4 with lines linewidth 1 linecolor rgb '#d98c2b'
set title 'the same from 2.4 s before the grip on, close up'
set ylabel 'along the belt (mm), across it (mm)'
set xrange [-2.4:1]
set yrange [-1:1]
plot for [i=0:{len(parts) - 1}] '{out}_track.dat' index i using 1:2 with lines linewidth 1.5 linecolor rgb '#1f6fb4', \\
     for [i=0:{len(parts) - 1}] '{out}_track.dat' index i using 1:3 with lines linewidth 1 linecolor rgb '#7d8a2e'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
