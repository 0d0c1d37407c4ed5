"""Prints the world snapshot nearest to a tick. Usage: nearest.py FOLDER TICK; snapshots are named <tick>.<anything>."""

import pathlib
import re
import sys

folder, tick = pathlib.Path(sys.argv[1]), int(sys.argv[2])
states = [p for p in folder.iterdir() if re.match(r"\D*\d+", p.name)]
if not states:
    sys.exit(f"{folder}: no snapshots")
print(min(states, key=lambda p: abs(int(re.search(r"\d+", p.name).group()) - tick)))
