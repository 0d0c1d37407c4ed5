"""Compiles each source that stdin names by itself and checks it with clang-tidy. Usage: lint_files.py BUILD < FILES

BUILD has compile_commands.json of a build without unity sources and precompiled headers. Prints what is found, then the
number of files; exit code 1 when anything is found or a file is not in the build.
"""

import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys


def check(command):
    """The findings in one source, as text."""
    arguments = shlex.split(command["command"])
    while arguments[0].endswith(("ccache", "cmake")) or arguments[0] in ("-E", "env") or "=" in arguments[0]:
        arguments = arguments[1:]  # the launcher
    output = arguments.index("-o")
    arguments = arguments[:output] + arguments[output + 2:]
    compiled = subprocess.run([*arguments, "-fsyntax-only"], cwd=command["directory"], capture_output=True, text=True, check=False)
    if compiled.returncode != 0:
        return compiled.stderr
    tidy = subprocess.run(["clang-tidy", "--quiet", "-p", command["build"], command["file"]], capture_output=True, text=True, check=False)
    return tidy.stdout if tidy.returncode != 0 else ""


def main():
    build = pathlib.Path(sys.argv[1])
    root = pathlib.Path.cwd()
    commands = {command["file"]: command for command in json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))}
    wanted, found = [], 0
    for line in sys.stdin:
        file = str(root / line.strip())
        if file in commands:
            wanted.append({**commands[file], "build": str(build)})
        else:
            print(f"{line.strip()}: no target of the build compiles this file")
            found += 1
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for findings in pool.map(check, wanted):
            if findings:
                print(findings)
                found += 1
    print(f"{len(wanted)} files compiled one by one and checked, {found} with findings")
    sys.exit(1 if found else 0)


main()
