"""Reads the recording of the task press, prints contact force and steps, and plots force and height over time with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT.dat, OUT.txt (figures) and OUT.png
"""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
BASE_HEIGHT = 0.7  # m, of the arm's base above the floor


def read_steps(path):
    """One (tick, instruction, name, height, force) per step; force is None where the wrist was not read."""
    steps = []
    for step in mrroc_trace.steps(path):
        if "arm" not in step.robots:
            continue
        height = step.robots["arm"].pose[2] + BASE_HEIGHT
        force = None
        if "wrist" in step.sensors:
            x, y, z = step.sensors["wrist"].values[:3]
            force = (x * x + y * y + z * z) ** 0.5
        steps.append((step.tick, step.instruction, step.move or step.wait, height, force))
    return steps


def main():
    recording, out = sys.argv[1:3]
    steps = read_steps(recording)
    with open(out + ".dat", "w", encoding="ascii") as data:
        for tick, _, _, height, force in steps:
            data.write(f"{tick * SERVO_PERIOD} {height} {'nan' if force is None else force}\n")
    down = [s for s in steps if s[2] == "ToolVelocity"]
    held = [s for s in steps if s[2] == "Hold" and s[4] is not None]
    contact = down[-1]
    peak = max(s[4] for s in steps if s[4] is not None)
    with open(out + ".txt", "w", encoding="ascii") as figures:
        figures.write(f"contact_tick={held[len(held) // 2][0]}\n")
        figures.write(f"contact_force={contact[4]}\n")
    print(f"contact at {contact[0] * SERVO_PERIOD:.3f} s with {contact[4]:.1f} N; held with {held[-1][4]:.1f} N, peak {peak:.1f} N")
    print(f"steps: {len(steps)} of {steps[-1][1]} instructions")
    script = f"""
set terminal pngcairo size 1100,620 font 'sans,12'
set output '{out}.png'
set title 'press: force at the wrist and height of the tool'
set xlabel 'time (s)'
set ylabel 'height above the floor (m)'
set y2label 'force (N)'
set ytics nomirror
set y2tics
set grid
set key top left
set arrow from {contact[0] * SERVO_PERIOD}, graph 0 to {contact[0] * SERVO_PERIOD}, graph 1 nohead dashtype 2 linecolor 'gray'
plot '{out}.dat' using 1:2 with lines linewidth 2 linecolor '#d95319' title 'height', \\
     '{out}.dat' using 1:3 axes x1y2 with lines linewidth 2 linecolor '#0072bd' title 'force'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


if __name__ == "__main__":
    main()
