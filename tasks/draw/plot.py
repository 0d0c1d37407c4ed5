"""Reads the recording of the task draw, prints the distances of the strokes from their paths, and plots them with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT_<stroke>.dat and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
STROKES = ("BlendedPath", "CartesianLine", "CartesianArc", "PoseSpline")


def place_of(pose):
    """Position of a pose, mm."""
    return tuple(1000 * v for v in pose[:3])


def read_strokes(path):
    """Per stroke (name, tick of each step, measured positions, commanded positions)."""
    strokes, last = [], None
    for step in mrroc_trace.steps(path):
        if step.move not in STROKES:
            continue
        if step.instruction != last:
            strokes.append((step.move, [], [], []))
            last = step.instruction
        _, ticks, measured, commanded = strokes[-1]
        arm = step.robots["arm"]
        ticks.append(arm.tick)
        measured.append(place_of(arm.pose))
        if arm.command:
            commanded.append(place_of(arm.command.target))
    return strokes


def beside(place, chain):
    """Distance of a position from a chain of positions."""
    least = math.inf
    for start, end in zip(chain, chain[1:]):
        way = [e - s for s, e in zip(start, end)]
        gone = [p - s for s, p in zip(start, place)]
        length = sum(w * w for w in way)
        u = 0 if length == 0 else min(max(sum(g * w for g, w in zip(gone, way)) / length, 0), 1)
        least = min(least, math.dist(place, [s + u * w for s, w in zip(start, way)]))
    return least


def speeds(places, interval):
    """mm/s from position to position."""
    return [math.dist(a, b) / interval for a, b in zip(places, places[1:])]


def main():
    recording, out = sys.argv[1:3]
    strokes = read_strokes(recording)
    files = []
    for number, (name, ticks, measured, commanded) in enumerate(strokes):
        interval = (ticks[-1] - ticks[0]) / (len(ticks) - 1) * SERVO_PERIOD
        errors = [beside(place, commanded) for place in measured[1:]]
        print(f"{name:13}: {interval * (len(ticks) - 1):5.2f} s, up to {max(speeds(commanded, interval)):5.1f} mm/s, "
              f"measured at most {max(errors):.2f} mm beside the path")
        files.append((f"{out}_{number}.dat", name))
        with open(files[-1][0], "w", encoding="ascii") as data:
            for k, (before, here) in enumerate(zip(measured, measured[1:])):
                speed = math.dist(before, here) / interval
                wanted = math.dist(commanded[k - 1], commanded[k]) / interval if 0 < k < len(commanded) else 0
                data.write(f"{k * interval} {here[1]} {here[2]} {speed} {wanted}\n")
    colours = dict(zip(STROKES, ("#0072bd", "#7e2f8e", "#d95319", "#77ac30")))
    drawing = ", \\\n".join(
        f"'{file}' using 2:3 with lines linewidth 2.5 linecolor '{colours[name]}' "
        + (f"title '{name}'" if name not in [n for _, n in files[:number]] else "notitle")
        for number, (file, name) in enumerate(files)
    )
    hull = next(file for file, name in files if name == "BlendedPath")
    script = f"""
set terminal pngcairo size 1300,620 font 'sans,12'
set output '{out}.png'
set multiplot layout 1,2
set grid
set title 'draw: the tool as measured, seen from in front of the arm'
set xlabel 'y (mm)'
set ylabel 'z (mm)'
set size ratio -1
set key top right
set yrange [-100:215]
plot {drawing}
set size noratio
set title 'speed along the hull, a blended path at 80 mm/s'
set xlabel 'time (s)'
set ylabel 'speed (mm/s)'
set yrange [0:100]
set key bottom center
plot '{hull}' using 1:5 with lines linewidth 2.5 linecolor '#0072bd' title 'commanded', \\
     '' using 1:4 with lines linewidth 1.5 linecolor '#888888' title 'measured'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
