"""Reads the recording of the task insert, prints the figures of the insertions, and plots them with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT_search.dat, OUT_depth.dat, OUT.txt (a tick with the peg in the hole) and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
HOLE = (750.0, 0.0)  # mm, in the arm's base frame
DEPTH = 25.0  # mm


def read_trials(path):
    """Per SpiralSearch the (tick, x, y, z, fx, fy, fz) (mm, N) of its steps and of the ForceControl after it."""
    trials, searching, last = [], False, None
    for step in mrroc_trace.steps(path):
        if step.move is None:
            continue
        if step.instruction != last:
            if step.move == "SpiralSearch":
                trials.append({"search": [], "insertion": []})
                part = "search"
            elif last is not None and searching:
                part = "insertion"
            else:
                part = None
            searching, last = step.move == "SpiralSearch", step.instruction
        if part is None:
            continue
        arm = step.robots["arm"]
        x, y, z = (1000 * v for v in arm.pose[:3])
        trials[-1][part].append((arm.tick, x - HOLE[0], y - HOLE[1], z, *arm.wrench[:3]))
    return trials


def main():
    recording, out = sys.argv[1:3]
    trials = read_trials(recording)
    inserted = 0
    with open(out + "_search.dat", "w", encoding="ascii") as search, open(out + "_depth.dat", "w", encoding="ascii") as depth:
        for number, trial in enumerate(trials, 1):
            first = trial["search"][0]
            steps = trial["search"] + trial["insertion"]
            for step in trial["search"]:
                search.write(f"{step[1]} {step[2]} {number}\n")
            for step in steps:
                depth.write(f"{(step[0] - first[0]) * SERVO_PERIOD} {first[3] - step[3]} {number}\n")
            search.write("\n\n")
            depth.write("\n\n")
            seconds = (trial["search"][-1][0] - first[0]) * SERVO_PERIOD
            whole = (steps[-1][0] - first[0]) * SERVO_PERIOD
            deepest = first[3] - min(step[3] for step in steps)
            sideways = max(math.hypot(step[4], step[5]) for step in steps)
            inserted += deepest > DEPTH - 1
            print(f"{number:2}: {math.hypot(first[1], first[2]):.2f} mm off, found after {seconds:.2f} s, {deepest:.1f} mm deep "
                  f"after {whole:.2f} s, at most {sideways:.1f} N sideways")
    print(f"{inserted} of {len(trials)} inserted")
    with open(out + ".txt", "w", encoding="ascii") as figures:
        figures.write(f"{trials[0]['insertion'][-1][0]}\n")
    script = f"""
set terminal pngcairo size 1300,620 font 'sans,12'
set output '{out}.png'
set multiplot layout 1,2
set grid
set title 'insert: the ways of the tip while it searches, the hole at 0, 0'
set xlabel 'x (mm)'
set ylabel 'y (mm)'
set size ratio -1
set key off
set object circle at first 0,0 radius first 0.25 fillcolor rgb '#bbbbbb' fillstyle solid noborder behind
plot for [i=0:{len(trials) - 1}] '{out}_search.dat' index i using 1:2 with lines linewidth 1.5
unset object
set size noratio
set title 'depth below the rim'
set xlabel 'time since the search began (s)'
set ylabel 'depth (mm)'
set yrange [27:-1]
plot for [i=0:{len(trials) - 1}] '{out}_depth.dat' index i using 1:2 with lines linewidth 1.5
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
