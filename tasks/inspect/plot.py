"""Reads the recording of the task inspect, prints the final distance and angle of the gauge, and plots the approach with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT_*.dat, OUT.txt (a tick of the end) and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
BASE = (0.0, 0.0, 0.7)  # m, of the arm in the world
PLATE, TURN = (0.82, 0.06, 0.36), (0.16, -0.12, 0.4)  # the scene's: m; rad about x, then the new y, then the new z
UPPER_SIDE = 0.010  # m above the plate's frame
STAND_OFF = 0.15  # m
PHASES = ("PositionServo", "ImageServo", "GuardedApproach")


def axes_of_plate():
    """Columns x, y, z of Rx Ry Rz, as for MuJoCo's euler."""
    a, b, c = TURN
    x = (math.cos(b) * math.cos(c), math.cos(a) * math.sin(c) + math.sin(a) * math.sin(b) * math.cos(c),
         math.sin(a) * math.sin(c) - math.cos(a) * math.sin(b) * math.cos(c))
    z = (math.sin(b), -math.sin(a) * math.cos(b), math.cos(a) * math.cos(b))
    y = (z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0])
    return x, y, z


def read_steps(path):
    """Per generator the (tick, mm beside the spot, mm before the plate, degrees off the normal) of its steps."""
    x, y, z = axes_of_plate()
    spot = [PLATE[i] + UPPER_SIDE * z[i] for i in range(3)]
    steps = {name: [] for name in PHASES}
    for step in mrroc_trace.steps(path):
        if step.move not in steps:
            continue
        arm = step.robots["arm"]
        *place, qw, qx, qy, qz = arm.pose
        away = [place[i] + BASE[i] - spot[i] for i in range(3)]
        beside = math.hypot(*(sum(a * b for a, b in zip(away, axis)) for axis in (x, y)))
        axis = (2 * (qx * qz + qw * qy), 2 * (qy * qz - qw * qx), 1 - 2 * (qx * qx + qy * qy))
        off = math.acos(min(1.0, -sum(a * b for a, b in zip(axis, z))))
        steps[step.move].append((arm.tick, 1000 * beside, 1000 * sum(a * b for a, b in zip(away, z)), math.degrees(off)))
    return steps


def main():
    recording, out = sys.argv[1:3]
    steps = read_steps(recording)
    first = steps[PHASES[0]][0][0]
    for name in PHASES:
        tick, beside, before, off = steps[name][-1]
        seconds = (tick - steps[name][0][0]) * SERVO_PERIOD
        print(f"{name:16} {seconds:4.1f} s: {beside:5.2f} mm beside the spot, {before:6.2f} mm before the plate, "
              f"{off:.2f} degrees off its normal")
        with open(f"{out}_{name}.dat", "w", encoding="ascii") as file:
            file.writelines(f"{(s[0] - first) * SERVO_PERIOD} {s[1]} {s[2]} {s[3]}\n" for s in steps[name])
    with open(f"{out}.txt", "w", encoding="ascii") as file:
        file.write(f"{steps[PHASES[-1]][-1][0]}\n")
    colours = ("#2050a0", "#208040", "#c03020")
    curve = lambda column: ", ".join(
        f"'{out}_{name}.dat' using 1:{column} with lines linewidth 2 linecolor rgb '{colour}' title '{name}'"
        for name, colour in zip(PHASES, colours))
    script = f"""
set terminal pngcairo size 1300,460 font 'sans,12'
set output '{out}.png'
set multiplot layout 1,3
set grid
set xlabel 'time (s)'
set yrange [0:*]
set key bottom left
set ylabel 'before the plate (mm)'
plot {curve(3)}
unset key
set ylabel 'beside the spot (mm)'
plot {curve(2)}
set ylabel 'off the normal (degrees)'
plot {curve(4)}
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
