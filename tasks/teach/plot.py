"""Reads the recording of the task teach, prints the distance of the replay from the taught path, and plots both with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT_taught.dat, OUT_replay.dat, OUT_distance.dat, OUT.txt (a tick of the leading) and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
BESIDE = 1.0  # mm: nearer to the first taught place, the replay has begun


def read_moves(path):
    """Per Move of the arm its name and the (tick, x, y, z) (mm) of its measured tool."""
    moves, last = [], None
    for step in mrroc_trace.steps(path):
        if step.process != "arm" or step.move is None:
            continue
        if step.instruction != last:
            moves.append((step.move, []))
            last = step.instruction
        arm = step.robots["arm"]
        moves[-1][1].append((arm.tick, *(1000 * v for v in arm.pose[:3])))
    return moves


def distance(point, way):
    """Distance of a point from the line through the points of `way`."""
    nearest = math.inf
    for a, b in zip(way, way[1:]):
        leg = [b[i] - a[i] for i in (1, 2, 3)]
        off = [point[i + 1] - a[i + 1] for i in range(3)]
        square = sum(v * v for v in leg)
        share = min(1.0, max(0.0, sum(u * v for u, v in zip(leg, off)) / square)) if square > 0 else 0.0
        nearest = min(nearest, math.dist(off, [share * v for v in leg]))
    return nearest


def main():
    recording, out = sys.argv[1:3]
    moves = read_moves(recording)
    taught = next(steps for name, steps in moves if name == "LeadThrough + TeachIn")
    replay = [steps for name, steps in moves if name == "Replay"][-1]
    first = next(i for i, step in enumerate(replay) if math.dist(step[1:], taught[0][1:]) < BESIDE)
    replay = replay[first:]
    distances = [(step[0], distance(step, taught)) for step in replay]
    length = sum(math.dist(a[1:], b[1:]) for a, b in zip(taught, taught[1:]))
    back = max(distance(step, replay) for step in taught)  # the reverse check: no part is missing
    rms = math.sqrt(sum(d * d for _, d in distances) / len(distances))
    print(f"taught {length:.0f} mm in {(taught[-1][0] - taught[0][0]) * SERVO_PERIOD:.1f} s; replayed in "
          f"{(replay[-1][0] - replay[0][0]) * SERVO_PERIOD:.1f} s, beside it by {rms:.2f} mm RMS, {max(d for _, d in distances):.2f} mm "
          f"at most; no taught position is farther than {back:.2f} mm from it")
    for name, steps in (("taught", taught), ("replay", replay)):
        with open(f"{out}_{name}.dat", "w", encoding="ascii") as file:
            file.writelines(f"{x} {y} {z}\n" for _, x, y, z in steps)
    with open(f"{out}_distance.dat", "w", encoding="ascii") as file:
        file.writelines(f"{(tick - replay[0][0]) * SERVO_PERIOD} {off}\n" for tick, off in distances)
    with open(f"{out}.txt", "w", encoding="ascii") as file:
        file.write(f"{taught[len(taught) // 2][0]}\n")
    script = f"""
set terminal pngcairo size 1300,560 font 'sans,12'
set output '{out}.png'
set multiplot layout 1,2
set grid
set title 'teach: the tool as it was led, and as it replays that'
set xlabel 'y (mm)'
set ylabel 'z (mm)'
set size ratio -1
plot '{out}_taught.dat' using 2:3 with lines linewidth 5 linecolor rgb '#f0b030' title 'led', \\
     '{out}_replay.dat' using 2:3 with lines linewidth 1.5 linecolor rgb '#2050a0' title 'replayed'
set size noratio
set title 'distance of the replay from the taught way'
set xlabel 'time (s)'
set ylabel 'distance (mm)'
set yrange [0:*]
plot '{out}_distance.dat' with lines linewidth 1.5 linecolor rgb '#2050a0' notitle
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
