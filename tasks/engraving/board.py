"""Writes the height field of the board that the task engraving carves: board.hfield, for MuJoCo.

The board is 200 mm wide (u, to the reader's right) and 100 mm deep (v, away from the reader), both from its centre. Its
surface is a wave with a trough across and a twist; `height` equals that of tests/tasks/engraving/board.hpp. The task program
uses neither.

Usage: board.py OUT
"""

import math
import struct
import sys

CELL = 0.002  # m: flat facets of this width stay within 3 um of the formula
WIDTH, DEPTH = 0.2, 0.1  # m


def height(u, v):
    """Height of the surface at (u, v), m."""
    return 0.0025 * math.sin(2 * math.pi * u / 0.16 + 0.8) + 0.9 * v * v + 0.45 * u * v + 0.02 * u


def main():
    rows, columns = round(WIDTH / CELL) + 1, round(DEPTH / CELL) + 1
    # the machine's x axis is v, its y axis -u; MuJoCo's rows go along y, its columns along x
    heights = [height(-(-WIDTH / 2 + r * CELL), -DEPTH / 2 + c * CELL) for r in range(rows) for c in range(columns)]
    with open(sys.argv[1], "wb") as out:
        out.write(struct.pack("<ii", rows, columns))
        out.write(struct.pack(f"<{len(heights)}f", *heights))
    print(f"lowest {min(heights):.9f} m, highest {max(heights):.9f} m: size and pos of the height field in engraving.xml")


if __name__ == "__main__":
    main()
