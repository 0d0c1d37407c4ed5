"""Reads the recording of this folder's demo and draws force and torque with and without the tool's weight, with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT.dat and OUT.png
"""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's


def norms(values):
    return [sum(x * x for x in part) ** 0.5 for part in (values[:3], values[3:6])]


def main():
    recording, out = sys.argv[1:3]
    steps, held = [], []
    for step in mrroc_trace.steps(recording):
        if len(step.sensors) != 2:
            continue
        plain, wrist = step.sensors["plain"], step.sensors["wrist"]
        steps.append((wrist.tick, plain.values, wrist.values))
        if step.ending and step.move == "Hold":
            held.append(norms(wrist.values))
    with open(out + ".dat", "w", encoding="ascii") as data:
        for tick, plain, wrist in steps:
            data.write(" ".join(str(v) for v in (tick * SERVO_PERIOD, *plain[:3], *norms(wrist), *norms(plain))) + "\n")
    print(f"at rest in {len(held)} postures at most {max(h[0] for h in held):.2f} N and "
          f"{max(h[1] for h in held):.3f} N m are left of the tool's weight")
    script = f"""
set terminal pngcairo size 900,560 font 'sans,11'
set output '{out}.png'
set multiplot layout 2,1
set grid
set lmargin 9
set rmargin 3
set key top right
set xrange [0:44]
set ylabel 'force (N)'
set title 'the wrist feels its tool, 1.1 kg, as it is turned about (sensor axes)'
plot '{out}.dat' using 1:2 with lines lc '#0072bd' title 'x', '' using 1:3 with lines lc '#77ac30' title 'y', \\
     '' using 1:4 with lines lc '#d95319' title 'z'
set title 'what is left of it: strain gauges, weight taken out, low-pass of 5 Hz'
set xlabel 'time (s)'
set ylabel '|force| (N)'
set logscale y
set yrange [0.003:40]
plot '{out}.dat' using 1:7 with lines lc '#aaaaaa' title 'with', '' using 1:5 with lines lc '#0072bd' title 'without'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
