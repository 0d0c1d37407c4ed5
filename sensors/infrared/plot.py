"""Reads the recording of this folder's demo and draws distance and presence over time, with gnuplot.

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
    readings = {}
    for step in mrroc_trace.steps(recording):
        if step.sensors:
            readings[step.sensors["eye"].tick] = [step.sensors[name].values for name in ("eye", "chattering")]
    changes = [0, 0]
    before = None
    with open(out + ".dat", "w", encoding="ascii") as data:
        for tick, (eye, chattering) in sorted(readings.items()):
            now = (eye[2], chattering[2])
            if before is not None:
                changes = [count + (a != b) for count, a, b in zip(changes, before, now)]
            before = now
            seen = f"{eye[0]}" if eye[1] else "?"
            data.write(f"{tick * SERVO_PERIOD} {seen} {eye[2]} {chattering[2]}\n")
    print(f"{len(readings)} readings; the presence changed {changes[0]} times, without hysteresis {changes[1]} times")
    script = f"""
set terminal pngcairo size 900,520 font 'sans,11'
set output '{out}.png'
set datafile missing '?'
set multiplot layout 2,1
set grid
set lmargin 10
set rmargin 3
set ylabel 'distance (m)'
set yrange [0.1:0.85]
set title 'a plate comes and goes; noise grows with the square of the distance'
set arrow from graph 0, first 0.4 to graph 1, first 0.4 nohead dt 2 lc '#555555'
set arrow from graph 0, first 0.45 to graph 1, first 0.45 nohead dt 2 lc '#555555'
plot '{out}.dat' using 1:($2) with points pt 7 ps 0.4 lc '#0072bd' notitle
unset arrow
set title 'presence from 0.40 m'
set xlabel 'time (s)'
set ylabel ''
set yrange [-0.3:3.4]
set ytics ('off' 0, 'on' 1, 'off' 1.3, 'on' 2.3)
set key opaque top right
plot '{out}.dat' using 1:($3+1.3) with steps lw 1.5 lc '#0072bd' title 'hysteresis 0.05 m', \\
     '' using 1:4 with steps lw 1.5 lc '#d95319' title 'none'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
