"""Reads the recording of this folder's demo and plots both sensors' rises and the force on the plate with gnuplot.

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
    steps = [[(sensors[name].tick, *sensors[name].values) for name in ("touched", "settled")] for sensors in readings]  # (tick, on, rises, level)
    with open(out + ".dat", "w", encoding="ascii") as data:
        for touched, settled in steps:
            data.write(f"{touched[0] * SERVO_PERIOD} {touched[2]} {settled[2]} {settled[1]} {touched[3]}\n")
    script = f"""
set terminal pngcairo size 900,420 font 'sans,11'
set output '{out}.png'
set title 'digital\\_input: a ball bounces on a switch'
set xlabel 'time (s)'
set ylabel 'rises'
set grid
set key top left
set yrange [0:*]
plot '{out}.dat' using 1:2 with steps linewidth 2 linecolor '#0072bd' title 'touched: every touch', \\
     '{out}.dat' using 1:3 with steps linewidth 2 linecolor '#d95319' title 'settled: debounced by 0.5 s'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
    print(f"{steps[-1][0][2]:.0f} rises, {steps[-1][1][2]:.0f} when debounced, after {steps[-1][0][0] * SERVO_PERIOD:.2f} s")


if __name__ == "__main__":
    main()
