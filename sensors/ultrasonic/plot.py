"""Reads the recording of this folder's demo and draws the readings of the four sensors over time, with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT.dat and OUT.png
"""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
SENSORS = ("cone", "ray", "rough", "smooth")


def main():
    recording, out = sys.argv[1:3]
    seen = {sensor: {} for sensor in SENSORS}
    for step in mrroc_trace.steps(recording):
        for name, sensor in step.sensors.items():
            distance, detected = sensor.values[:2]
            seen[name][sensor.tick] = distance if detected else None
    with open(out + ".dat", "w", encoding="ascii") as data:
        for tick in sorted(seen["cone"]):
            columns = [seen[sensor].get(tick) for sensor in SENSORS]
            data.write(f"{tick * SERVO_PERIOD} " + " ".join("?" if c is None else f"{c}" for c in columns) + "\n")
    for sensor in SENSORS:
        part = sum(value is not None for value in seen[sensor].values()) / len(seen[sensor])
        print(f"{sensor:7} sees something in {100 * part:.0f} % of {len(seen[sensor])} readings")
    script = f"""
set terminal pngcairo size 900,520 font 'sans,11'
set output '{out}.png'
set datafile missing '?'
set multiplot layout 2,1 margins 0.08,0.98,0.10,0.93 spacing 0,0.14
set grid
set ylabel 'distance (m)'
set key opaque top right
set title 'a post swings across the beam, 1 m away'
set yrange [0.95:1.03]
plot '{out}.dat' using 1:($2) with points pt 7 ps 0.45 lc '#0072bd' title 'cone of 0.26 rad', \\
     '' using 1:($3) with points pt 6 ps 0.9 lc '#d95319' title 'one ray'
set title 'a plate turns by 0.6 rad to either side, 1 m away'
set xlabel 'time (s)'
set yrange [0.88:1.07]
plot '{out}.dat' using 1:($4) with points pt 7 ps 0.45 lc '#0072bd' title 'rough plate', \\
     '' using 1:($5) with points pt 6 ps 0.9 lc '#d95319' title 'mirror, max\\_incidence 0.1 rad'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
