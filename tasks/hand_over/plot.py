"""Reads the recording and the snapshots of the task hand_over, prints the figures of each hand-over, and plots them with gnuplot.

Usage: plot.py RECORDING SNAPSHOTS OUT
writes OUT_giver.dat, OUT_receiver.dat, OUT_height.dat, OUT.txt (the tick at which the second bar is pulled) and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
PLACES = [(0.9, 0.5), (0.8, 0.5), (0.7, 0.5)]  # m, of the bars on the table, in the world
SHOWN = 1  # the bar whose forces are drawn


def read_forces(path):
    """Per arm the (tick, pull in N) of its steps, and the ticks at which the giver detected a pull."""
    forces, pulls = {"giver": [], "receiver": []}, []
    for step in mrroc_trace.steps(path):
        for name, robot in step.robots.items():
            if name not in forces or robot.wrench is None:
                continue
            tick, pull = robot.tick, -robot.wrench[1]
            forces[name].append((tick, pull))
            if step.conditions.get("pulled"):
                pulls.append((tick, pull))
    return forces, pulls


def read_bars(folder):
    """The (tick, (x, y, z) per bar in m) of each snapshot; the bars are the first free bodies of the world."""
    states = []
    for path in sorted(folder.glob("*.state")):
        lines = path.read_text(encoding="ascii").split("\n")
        numbers = [float(value) for value in lines[2 : 2 + 7 * len(PLACES)]]
        states.append((int(lines[1].split()[0]), [tuple(numbers[7 * bar : 7 * bar + 3]) for bar in range(len(PLACES))]))
    return states


def main():
    recording, snapshots, out = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    forces, pulls = read_forces(recording)
    bars = read_bars(snapshots)
    for number, (tick, pull) in enumerate(pulls):
        height = min(bars, key=lambda state: abs(state[0] - tick))[1][number][2]
        x, y, _ = bars[-1][1][number]
        off = 1000 * math.hypot(x - PLACES[number][0], y - PLACES[number][1])
        print(f"bar {number + 1}: handed over {1000 * height:.0f} mm above the floor at {tick * SERVO_PERIOD:.1f} s, when the giver "
              f"felt {pull:.1f} N; lies {off:.2f} mm off its place")
    for robot, steps in forces.items():
        with open(f"{out}_{robot}.dat", "w", encoding="ascii") as data:
            last = None
            for tick, pull in steps:
                if last is not None and tick - last > 30:
                    data.write("\n")  # no step between: no line
                data.write(f"{(tick - pulls[SHOWN][0]) * SERVO_PERIOD} {pull}\n")
                last = tick
    with open(f"{out}_height.dat", "w", encoding="ascii") as data:
        for tick, at in bars:
            data.write(f"{tick * SERVO_PERIOD} {' '.join(str(1000 * z) for _, _, z in at)}\n")
    with open(out + ".txt", "w", encoding="ascii") as figures:
        figures.write(f"{pulls[SHOWN][0]}\n")
    arrows = "\n".join(f"set arrow from {tick * SERVO_PERIOD}, graph 0 to {tick * SERVO_PERIOD}, graph 1 nohead dashtype 3 "
                       f"linecolor '#888888'" for tick, _ in pulls)
    script = f"""
set terminal pngcairo size 1300,620 font 'sans,12'
set output '{out}.png'
set multiplot layout 1,2
set grid
set key top right
set title 'hand\\_over: the bars, handed over at the dotted lines'
set xlabel 'time (s)'
set ylabel "height of the bar's middle above the floor (mm)"
set yrange [520:980]
{arrows}
plot for [bar=1:{len(PLACES)}] '{out}_height.dat' using 1:bar+1 with lines linewidth 2 title sprintf('bar %d', bar)
unset arrow
set key top left
set title 'the wrists at the hand-over of bar {SHOWN + 1}'
set xlabel 'time since the giver felt the pull (s)'
set ylabel 'pull at the bar (N)'
set xrange [-3:2.5]
set yrange [-4:16]
set arrow from graph 0, first 6 to graph 1, first 6 nohead dashtype 3 linecolor '#888888'
set arrow from 0, graph 0 to 0, graph 1 nohead dashtype 3 linecolor '#888888'
set label 'the giver begins to open' at 0.05, graph 0.06
plot '{out}_giver.dat' using 1:2 with lines linewidth 2 linecolor '#0072bd' title 'felt by the giver', \\
     '{out}_receiver.dat' using 1:2 with lines linewidth 2 linecolor '#d95319' title 'felt by the receiver'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
