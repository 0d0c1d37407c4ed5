#!/usr/bin/env python3
"""Stops the task cooperative_transfer at random steps of the bar's way and prints the internal force that it meets.

    bench/stops_of_transfer.py build              # 20 seeds of each kind
    bench/stops_of_transfer.py build --seeds 200

Kinds: none, a pause of 1 s, and commands of the MP that are late by 40 ticks for a while. Lockstep, an exact world; the
internal force is half of the difference of the forces of the bar on the arms, from the wrists.
"""

import argparse
import concurrent.futures
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SOURCE / "scripts"))
import mrroc_trace

TASK = SOURCE / "tasks/cooperative_transfer/cooperative_transfer.toml"
FIRST, LAST = 2500, 7500  # ticks between which the bar is carried
TICKS_OF_STEP = 10


def force(build, kind, seed):
    """Largest internal force of one run, N, its RMS, and whether a command was late."""
    at = random.Random(f"{kind} {seed}").randrange(FIRST, LAST)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        command = [build / "bin/mrroc", "run", TASK, "--clock", "lockstep", "--quiet", "--black-box", ""]
        command += ["--record", folder / "run.mcap"]
        if kind == "pause":
            events = f"[[events]]\ntick = {at}\ncommand = \"pause\"\n[[events]]\ntick = {at + 500}\ncommand = \"resume\"\n"
            (folder / "events.toml").write_text(events)
            command += ["--events", folder / "events.toml"]
        elif kind == "late command":
            command += ["--inject", f"delay mp by 40 at tick {at} for {TICKS_OF_STEP} ticks"]
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=600)
        if done.returncode != 0:
            sys.exit(f"{kind}, seed {seed}: exit code {done.returncode}\n{done.stderr}")
        report = subprocess.run(
            [build / "bin/cooperative_transfer_report", folder / "run.mcap"], capture_output=True, text=True, check=True
        ).stdout
        late = any(robot.late for step in mrroc_trace.steps(folder / "run.mcap") for robot in step.robots.values())
    most, mean = re.search(r"internal force at most ([\d.]+) N, ([\d.]+) N RMS", report).groups()
    return float(most), float(mean), late


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--seeds", type=int, default=20)
    arguments = parser.parse_args()
    os.environ["MRROC"] = str(arguments.build.resolve() / "bin/mrroc")  # of mrroc_trace
    print(f"{'stop':<14} {'runs':>5} {'worst, N':>9} {'median, N':>10} {'RMS, N':>7} {'late':>5}")
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for kind in ("none", "pause", "late command"):
            seeds = range(1, 2 if kind == "none" else arguments.seeds + 1)
            runs = sorted(pool.map(lambda seed, kind=kind: force(arguments.build, kind, seed), seeds))
            worst, median = runs[-1][0], runs[len(runs) // 2][0]
            rms = (sum(mean**2 for _, mean, _ in runs) / len(runs)) ** 0.5
            late = sum(run[2] for run in runs)
            print(f"{kind:<14} {len(runs):>5} {worst:>9.1f} {median:>10.1f} {rms:>7.1f} {late:>5}", flush=True)


if __name__ == "__main__":
    main()
