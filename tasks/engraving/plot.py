"""Reads the recording of the task engraving, prints the carved depth, and draws the engraved board with gnuplot.

The board's true surface is the formula of board.py, which the task does not use. The picture is the surface after a ball-nose cutter of
3 mm along the measured path of its tip.

Usage: plot.py RECORDING OUT    writes OUT.rgb, OUT.dat, OUT.txt (the last tick in which it carves) and OUT.png
"""

import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import board
import mrroc_trace

SERVO_PERIOD = 0.002  # s, the deployment's
DESIRED = 0.001  # m, the depth
ZERO = -0.551  # m: of board.height in the machine's base frame
MIDDLE = 0.05  # m: of the board, in x
CUTTER = 0.0015  # m, radius
PIXEL = 0.0002  # m


def slopes(u, v):
    e = 1e-6
    return ((board.height(u + e, v) - board.height(u - e, v)) / (2 * e),
            (board.height(u, v + e) - board.height(u, v - e)) / (2 * e))


def read(path):
    """Per step with the tip in the wood (tick, u, v, depth, whether a stroke is carved, thrust, drag); the number of touches;
    the last tick."""
    way, touches, last, tick = [], 0, None, 0
    for step in mrroc_trace.steps(path):
        machine = step.robots.get("machine")
        if step.move is None or machine is None or machine.wrench is None:
            continue
        tick = step.tick
        touches += step.move == "ToolVelocity" and step.ending is not None
        x, y, z = machine.pose[:3]
        u, v = -y, x - MIDDLE
        du, dv = slopes(u, v)
        depth = (board.height(u, v) + ZERO - z) / math.sqrt(1 + du * du + dv * dv)
        force = machine.wrench[:3]
        if depth > 0 and step.move in ("PoseSpline", "CartesianLine"):
            way.append((tick, u, v, depth, step.move == "PoseSpline", -force[2], math.hypot(force[0], force[1])))
    return way, touches // 2, tick


def carve(way):
    """The depth of the wood that is gone, per pixel, m."""
    width, breadth = round(board.WIDTH / PIXEL), round(board.DEPTH / PIXEL)
    gone = [[0.0] * width for _ in range(breadth)]
    reach = math.ceil(CUTTER / PIXEL)
    for (tick, u0, v0, d0, *_), (after, u1, v1, d1, *_) in zip(way, way[1:]):
        parts = max(1, math.ceil(math.hypot(u1 - u0, v1 - v0) / PIXEL)) if after - tick < 20 else 1
        for part in range(parts):
            u, v, depth = (a + (b - a) * part / parts for a, b in ((u0, u1), (v0, v1), (d0, d1)))
            column, row = (u + board.WIDTH / 2) / PIXEL, (board.DEPTH / 2 - v) / PIXEL
            for r in range(int(row) - reach, int(row) + reach + 1):
                for c in range(int(column) - reach, int(column) + reach + 1):
                    off = PIXEL * math.hypot(r + 0.5 - row, c + 0.5 - column)
                    if off < CUTTER and 0 <= r < breadth and 0 <= c < width:
                        left = depth - CUTTER + math.sqrt(CUTTER * CUTTER - off * off)
                        gone[r][c] = max(gone[r][c], left)
    return gone


def paint(gone):
    """Bytes of the picture: wood, darker with the depth, under a light from the upper left."""
    light = (-0.45, 0.45, 0.77)
    deepest = max(max(row) for row in gone)
    grid = [[board.height((c + 0.5) * PIXEL - board.WIDTH / 2, board.DEPTH / 2 - (r + 0.5) * PIXEL) - gone[r][c]
             for c in range(len(gone[0]))] for r in range(len(gone))]
    pixels = bytearray()
    for r, row in enumerate(grid):
        for c in range(len(row)):
            du = (row[min(c + 1, len(row) - 1)] - row[max(c - 1, 0)]) / (2 * PIXEL)
            dv = (grid[max(r - 1, 0)][c] - grid[min(r + 1, len(grid) - 1)][c]) / (2 * PIXEL)
            shade = max(0.0, -light[0] * du - light[1] * dv + light[2]) / math.sqrt(1 + du * du + dv * dv)
            burnt = gone[r][c] / deepest
            grain = 1 + 0.03 * math.sin(900 * (board.DEPTH * r / len(grid) + 0.1 * row[c]))
            for bare, deep in ((222, 92), (176, 52), (120, 24)):
                colour = (bare + (deep - bare) * burnt) * grain * (0.35 + 0.85 * shade)
                pixels.append(max(0, min(255, round(colour))))
    return pixels


def main():
    recording, out = sys.argv[1:3]
    way, touches, last = read(recording)
    carved = [step for step in way if step[4]]
    error = math.sqrt(sum((step[3] - DESIRED) ** 2 for step in carved) / len(carved))
    worst = max(abs(step[3] - DESIRED) for step in carved)
    length = sum(math.hypot(b[1] - a[1], b[2] - a[2]) for a, b in zip(carved, carved[1:]) if b[0] - a[0] < 20)
    thrust, drag = (sum(step[i] for step in carved) / len(carved) for i in (5, 6))
    print(f"touched at {touches} places; {1000 * length:.0f} mm carved {1000 * DESIRED:.1f} mm deep, error {1000 * error:.3f} mm "
          f"RMS, {1000 * worst:.3f} mm at most; {last * SERVO_PERIOD:.0f} s")
    print(f"the wood pushes the cutter out with {thrust:.1f} N and holds it back with {drag:.1f} N on average")
    with open(out + ".txt", "w", encoding="ascii") as figures:
        figures.write(f"{carved[-1][0]}\n")
    with open(out + ".dat", "w", encoding="ascii") as data:
        travelled = 0.0
        for before, step in zip(carved, carved[1:]):
            if step[0] - before[0] < 20:
                travelled += math.hypot(step[1] - before[1], step[2] - before[2])
            data.write(f"{1000 * travelled} {1000 * step[3]}\n")
    gone = carve(way)
    with open(out + ".rgb", "wb") as picture:
        picture.write(paint(gone))
    script = f"""
set terminal pngcairo size 1400,1010 font 'sans,13'
set output '{out}.png'
set multiplot
set key off
set origin 0,0.32
set size 1,0.68
set lmargin 10
set rmargin 4
set title 'engraving: the board along the measured path of the cutter, the deeper the darker'
set xlabel 'to the right (mm)'
set ylabel 'away from the reader (mm)'
set size ratio -1
set xrange [{-500 * board.WIDTH}:{500 * board.WIDTH}]
set yrange [{-500 * board.DEPTH}:{500 * board.DEPTH}]
plot '{out}.rgb' binary array=({len(gone[0])},{len(gone)}) format='%uchar' flipy dx={1000 * PIXEL} dy={1000 * PIXEL} \\
  origin=({-500 * board.WIDTH + 500 * PIXEL},{-500 * board.DEPTH + 500 * PIXEL}) with rgbimage
set origin 0,0
set size noratio 1,0.32
set title 'depth below the true surface, and what is allowed'
set xlabel 'way in the wood (mm)'
set ylabel 'depth (mm)'
set xrange [0:*]
set yrange [{1000 * DESIRED - 0.15}:{1000 * DESIRED + 0.15}]
set grid
set object rectangle from graph 0, first {1000 * DESIRED - 0.1} to graph 1, first {1000 * DESIRED + 0.1} \\
  fillcolor rgb '#dddddd' fillstyle solid noborder behind
plot '{out}.dat' using 1:2 with lines linewidth 1.5 linecolor '#0072bd'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


if __name__ == "__main__":
    main()
