#!/usr/bin/env python3
"""Writes <robot>.urdf and <robot>.xml (MJCF) of robots of the IRb-6's family from their <robot>.toml, so that a measured
number is entered in one file.

    robots/irb6/describe.py robots/irb60               # writes both
    robots/irb6/describe.py --check robots/irb6 ...    # lists outdated files, exit code 1
"""

import argparse
import pathlib
import sys
import tomllib

sys.dont_write_bytecode = True  # the folder may be an installation's
from description import arm, mjcf, urdf  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    parser.add_argument("folders", nargs="+", type=pathlib.Path, help="robots/<robot>")
    arguments = parser.parse_args()
    stale = False
    for folder in arguments.folders:
        name = folder.resolve().name
        robot = tomllib.loads((folder / f"{name}.toml").read_text())
        links = arm.chain(robot)
        for file, text in ((folder / f"{name}.urdf", urdf.text(robot, links)),
                           (folder / f"{name}.xml", mjcf.text(robot, links))):
            if file.exists() and file.read_text() == text:
                continue
            if arguments.check:
                print(f"{file} differs from {name}.toml: run robots/irb6/describe.py {folder}")
                stale = True
            else:
                file.write_text(text)
    return 1 if stale else 0


sys.exit(main())
