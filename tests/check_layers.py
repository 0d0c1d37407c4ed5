"""Checks every #include between the folders of the project: a file includes only from its own layer and from lower ones.

Usage: check_layers.py SOURCE_DIR
"""

import pathlib
import re
import sys

LAYERS = [
    ("include/mrroc",),
    ("src/core",),
    ("src/plugin", "src/messages"),
    ("src/geometry", "src/kinematics", "src/calibration", "src/regulation"),
    ("src/language",),
    ("src/clock", "src/config", "src/links", "src/world", "src/faults", "src/can", "src/canopen", "src/command"),
    ("src/recording",),
    ("src/process",),
    ("mp", "ecp", "edp", "vsp"),
    ("robots", "sensors", "drivers"),
    ("sim", "tasks", "calibration", "cli"),
]
RANK = {folder: rank for rank, folders in enumerate(LAYERS) for folder in folders}

# the public headers give a task their classes, including those that they include of the language
PUBLIC = {"include/mrroc": {"src/core", "src/geometry", "src/language"}}

# known exceptions: the cameras of the simulated world
MISPLACED = {
    ("sensors", "sim/errors/true_errors.hpp"),
    ("sensors", "sim/rendering/camera.hpp"),
    ("sensors", "sim/scene/model.hpp"),
    ("sensors", "sim/simulation.hpp"),
}


def folder_of(path):
    return next((folder for folder in sorted(RANK, key=len, reverse=True) if path.startswith(folder + "/")), None)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    folders = {folder.split("/")[0] for folder in RANK}
    files = {
        path.relative_to(root).as_posix(): path for top in sorted(folders) for path in (root / top).rglob("*.[ch]pp")
    }
    problems = []
    used = set()
    includes = 0
    for name, path in sorted(files.items()):
        own = folder_of(name)
        if own is None:
            problems.append(f"{name}: its folder is in no layer of {pathlib.Path(__file__).name}")
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = re.match(r"\s*#\s*include\s+[\"<]([^\">]+)[\">]", line)
            if not match:
                continue
            given = match.group(1)
            candidates = (f"{pathlib.PurePosixPath(name).parent}/{given}", given, f"src/{given}", f"include/{given}")
            found = next((candidate for candidate in candidates if candidate in files), None)
            if found is None or folder_of(found) == own:
                continue
            includes += 1
            other = folder_of(found)
            if other is None or RANK[other] <= RANK[own] or other in PUBLIC.get(own, ()):
                continue
            if (own, found) in MISPLACED:
                used.add((own, found))
                continue
            problems.append(f"{name}:{number}: {own} includes {found}: {other} is a later layer")
    problems += [f"{own} no longer includes {found}: take it out of MISPLACED" for own, found in sorted(MISPLACED - used)]
    print("\n".join(problems) or f"{includes} includes between folders of {len(files)} files")
    return 1 if problems or includes == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
