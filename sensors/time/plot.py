"""Reads the recording of this folder's demo and plots the stop watch's time over the deployment's time with gnuplot.

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
    readings = [(step.instruction, *step.sensors["watch"].values) for step in mrroc_trace.steps(recording) if step.sensors]
    with open(out + ".dat", "w", encoding="ascii") as data:
        before = None
        for instruction, time, tick in readings:
            if before not in (None, instruction):
                data.write("\n")  # zeroed: no line from there to here
            before = instruction
            data.write(f"{tick * SERVO_PERIOD} {str(time).removesuffix('.0')}\n")
    script = f"""
set terminal pngcairo size 900,420 font 'sans,11'
set output '{out}.png'
set title 'time: a stop watch, set to zero twice'
set xlabel 'time of the deployment (s)'
set ylabel 'channel time (s)'
set grid
plot '{out}.dat' with lines linewidth 2 linecolor '#0072bd' notitle
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
    print(f"{len(readings)} readings, the last at tick {readings[-1][2]:.0f}")


if __name__ == "__main__":
    main()
