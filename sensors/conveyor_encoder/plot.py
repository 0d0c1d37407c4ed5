"""Reads the recording of this folder's demo and plots both encoders' positions and the belt's velocity with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT.dat and OUT.png
"""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's


def main():
    recording, out = sys.argv[1:3]
    readings = [step.sensors for step in mrroc_trace.steps(recording) if step.sensors]
    steps = [[(sensors[name].tick, *sensors[name].values) for name in ("fine", "coarse")] for sensors in readings]  # (tick, position, velocity)
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
