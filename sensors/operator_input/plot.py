"""Reads the recording of this folder's demo and plots the time of each question and its answer with gnuplot.

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
    questions = {}  # instruction: [sensor, first tick, last tick, answer]
    for step in mrroc_trace.steps(recording):
        for name, sensor in step.sensors.items():
            question = questions.setdefault(step.instruction, [name, sensor.tick, sensor.tick, None])
            question[2] = sensor.tick
            answered, value = sensor.values
            if answered > 0:
                question[3] = value
    rows = sorted({question[0] for question in questions.values()})
    with open(out + ".dat", "w", encoding="ascii") as data:
        for sensor, first, last, answer in questions.values():
            data.write(f"{first * SERVO_PERIOD} {rows.index(sensor)} {(last - first) * SERVO_PERIOD} {answer:g}\n")
    tics = ", ".join(f"'{row}' {index}" for index, row in enumerate(rows))
    script = f"""
set terminal pngcairo size 900,300 font 'sans,11'
set output '{out}.png'
set title 'operator\\_input: open questions and their answers'
set xlabel 'time (s)'
set ytics ({tics})
set yrange [-0.7:{len(rows) - 0.3}]
set xrange [0:*]
set offsets 0, 0.1, 0, 0
set grid xtics
plot '{out}.dat' using 1:2:3:(0) with vectors nohead linewidth 8 linecolor '#0072bd' notitle, \\
     '{out}.dat' using ($1+$3):2 with points pointtype 7 pointsize 1.6 linecolor '#d95319' notitle, \\
     '{out}.dat' using ($1+$3):2:4 with labels offset 0,1.2 notitle
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
    for sensor, first, last, answer in questions.values():
        print(f"{sensor}: asked at tick {first}, answered {answer:g} at tick {last}")


if __name__ == "__main__":
    main()
