"""Reads the recording of the task polish, prints the force and angle errors, and plots the paths and the force with gnuplot.

Usage: plot.py RECORDING OUT    writes OUT_*.dat, OUT.txt (a tick of the lines) and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
FORCE = 8.0  # N, of the lines
CENTRE, RADIUS = (790.0, 10.0, -580.0), 460.0  # mm in the arm's base frame: of the ball, with the pad
REACH = 60.0  # mm, of the lines from the middle, and from line to line
SETTLED = 2.0  # s until force and orientation have settled


def read_moves(path):
    """Per Move its name and the (tick, x, y, z, z axis, fx, fy, fz) (mm, N) of its steps."""
    moves, last = [], None
    for step in mrroc_trace.steps(path):
        if step.move is None:
            continue
        if step.instruction != last:
            moves.append((step.move, []))
            last = step.instruction
        arm = step.robots["arm"]
        x, y, z, qw, qx, qy, qz = arm.pose
        axis = (2 * (qx * qz + qw * qy), 2 * (qy * qz - qw * qx), 1 - 2 * (qx * qx + qy * qy))
        force = arm.wrench[:3] if arm.wrench else [0, 0, 0]
        moves[-1][1].append((arm.tick, 1000 * x, 1000 * y, 1000 * z, axis, *force))
    return moves


def lean(step):
    """Angle of the tool's z axis to the surface's normal, degrees."""
    normal = [(step[1 + i] - CENTRE[i]) for i in range(3)]
    length = math.hypot(*normal)
    return math.degrees(math.acos(min(1.0, -sum(a * b for a, b in zip(step[4], normal)) / length)))


def beside(step):
    """Distance of a step from the nearest line, in x and y, mm: three lines along x, joined at their ends."""
    x, y = step[1] - 800, step[2]
    legs = [((-REACH, i * REACH), (REACH, i * REACH)) for i in (-1, 0, 1)]
    legs += [((REACH, 0), (REACH, REACH)), ((-REACH, -REACH), (-REACH, 0))]
    return min(math.hypot(x - min(max(x, a[0]), b[0]), y - min(max(y, a[1]), b[1])) for a, b in legs)


def main():
    recording, out = sys.argv[1:3]
    moves = read_moves(recording)
    steps = next(steps for name, steps in moves if name == "SurfaceFollowing")
    circle = next(steps for name, steps in moves if name == "Impedance")
    settled = [step for step in steps if (step[0] - steps[0][0]) * SERVO_PERIOD > SETTLED]
    errors = [-step[7] - FORCE for step in settled]
    length = sum(math.dist(a[1:4], b[1:4]) for a, b in zip(steps, steps[1:]))
    print(f"lines: {length:.0f} mm in {(steps[-1][0] - steps[0][0]) * SERVO_PERIOD:.1f} s, {FORCE:.0f} N, error "
          f"{math.sqrt(sum(e * e for e in errors) / len(errors)):.2f} N RMS, {max(abs(e) for e in errors):.2f} N at most; z axis off the "
          f"normal by {max(lean(step) for step in settled):.1f} degrees at most; {max(beside(step) for step in settled):.2f} mm beside the "
          f"lines at most")
    rubbing = [step for step in circle if (step[0] - circle[0][0]) * SERVO_PERIOD > SETTLED]
    radii = [math.hypot(step[1] - 800, step[2]) for step in rubbing]
    forces = [-step[7] for step in rubbing]
    print(f"circles on a spring: radius {min(radii):.1f} to {max(radii):.1f} mm, {min(forces):.1f} to {max(forces):.1f} N")
    for name, part in (("lines", steps), ("circle", circle)):
        with open(f"{out}_{name}.dat", "w", encoding="ascii") as file:
            file.writelines(
                f"{s[1]} {s[2]} {s[3]} {(s[0] - part[0][0]) * SERVO_PERIOD} {-s[7]} {lean(s)}\n" for s in part
            )
    with open(f"{out}.txt", "w", encoding="ascii") as file:
        file.write(f"{steps[len(steps) // 3][0]}\n")
    script = f"""
set terminal pngcairo size 1300,560 font 'sans,12'
set output '{out}.png'
set multiplot layout 1,2
set grid
set title 'polish: the ways of the pad'
set xlabel 'x (mm)'
set ylabel 'y (mm)'
set size ratio -1
plot '{out}_lines.dat' using 1:2 with lines linewidth 1.5 linecolor rgb '#2050a0' title 'lines', \\
     '{out}_circle.dat' using 1:2 with lines linewidth 1.5 linecolor rgb '#c03020' title 'circles on a spring'
set size noratio
set title 'along the lines'
set xlabel 'time (s)'
set ylabel 'force (N)'
set y2label 'off the normal (degrees)'
set y2tics
set yrange [0:12]
set y2range [0:12]
plot '{out}_lines.dat' using 4:5 with lines linewidth 1.5 linecolor rgb '#2050a0' title 'force', \\
     '{out}_lines.dat' using 4:6 axes x1y2 with lines linewidth 1.5 linecolor rgb '#c03020' title 'angle'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


main()
