#!/usr/bin/env python3
"""Runs tasks in worlds with errors and prints, for each, in how many of the seeds it succeeds.

    bench/errors/tasks_with_errors.py build                        # every task, set modest, seeds 1 to 5
    bench/errors/tasks_with_errors.py build press insert --seeds 1 2 --least press=2

A task succeeds when `mrroc run` ends with 0 and its outcome, where a check below knows one, is the one that its test
expects. `--least TASK=N`: exit code 1 unless at least N seeds succeed.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "scripts"))
import mrroc_trace


def insert(recording):
    """Ten pegs go in by 24 mm."""
    trials, searching, going = [], None, None
    top = 0.0
    for step in mrroc_trace.steps(recording):
        search = step.move == "SpiralSearch"
        if not search and step.move != "ForceControl":
            continue
        height = step.robots["arm"].pose[2]
        if search and step.instruction != searching:
            trials.append(0.0)
            searching, going, top = step.instruction, None, height
        if not search and going is None:
            going = step.instruction
        if trials and (search or step.instruction == going):
            trials[-1] = max(trials[-1], top - height)
    wrong = [depth for depth in trials if depth < 0.024]
    if len(trials) == 10 and not wrong:
        return ""
    return f"{len(trials) - len(wrong)} of 10 pegs are in"


CHECKS = {"insert": insert}


def run(build, task, errors, seed, folder):
    recording = folder / f"{task}.{seed}.mcap"
    command = [str(build / "bin/mrroc"), "run", str(SOURCE / f"tasks/{task}/{task}.toml"), "--clock", "lockstep"]
    command += ["--black-box", ""]
    if task in CHECKS:
        command += ["--record", str(recording)]
    if errors:
        command += ["--errors", errors, "--seed", str(seed)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=600)
    except subprocess.TimeoutExpired:
        return "does not end"
    output = done.stdout + done.stderr
    try:
        if done.returncode != 0:
            lines = [line for line in output.splitlines() if re.search("error|failed|limit", line, re.IGNORECASE)]
            return f"exit code {done.returncode}: {(lines or output.splitlines() or ['no output'])[-1].strip()[:150]}"
        return CHECKS[task](recording) if task in CHECKS else ""
    finally:
        recording.unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, help="build folder")
    parser.add_argument("tasks", nargs="*", help="folders of tasks/; left out: all that simulate a world")
    parser.add_argument("--errors", default="modest", help="set of errors; empty: exact worlds")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3, 4, 5])
    parser.add_argument("--least", action="append", default=[], metavar="TASK=N")
    arguments = parser.parse_args()
    os.environ["MRROC"] = str(arguments.build.resolve() / "bin/mrroc")  # of mrroc_trace
    least = {task: int(count) for task, count in (each.split("=") for each in arguments.least)}
    tasks = arguments.tasks or sorted(
        path.stem for path in SOURCE.glob("tasks/*/*.toml")
        if path.stem == path.parent.name and "[sim]" in path.read_text(encoding="utf-8"))
    bad = False
    print(f"| task | seeds of {len(arguments.seeds)} | failures |\n|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for task in tasks:
            results = {seed: run(arguments.build.resolve(), task, arguments.errors, seed, pathlib.Path(folder))
                       for seed in arguments.seeds}
            failures = [f"{seed}: {problem}" for seed, problem in results.items() if problem]
            count = len(results) - len(failures)
            bad = bad or count < least.get(task, 0)
            print(f"| {task} | {count} | {'; '.join(failures)} |", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
