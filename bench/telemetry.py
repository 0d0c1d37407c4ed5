"""What watchers cost a run: `press` in lockstep without and with watchers of all states, in pairs, and its traces.

telemetry.py [BUILD_DIR] [--pairs N] [--watchers N]: prints the ratio of the times (median and range over the pairs), and whether all
traces are equal. The watchers' own time is in it: they share the processors.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

DEPLOYMENT = pathlib.Path(__file__).resolve().parent.parent / "tasks/press/press.toml"


def run(mrroc, folder, watchers):
    """Seconds of wall time of the task, and the hash of its trace."""
    environment = {**os.environ, "MRROC_RUNTIME_DIR": f"{folder}/run"}
    trace = f"{folder}/trace"
    with subprocess.Popen([mrroc, "run", DEPLOYMENT, "--clock", "lockstep", "--hold", "--quiet", "--black-box=", "--trace", trace],
                          env=environment, stdout=subprocess.DEVNULL) as command:
        while subprocess.run([mrroc, "status"], env=environment, capture_output=True, check=False).returncode != 0:
            time.sleep(0.05)
        echoes = [subprocess.Popen([mrroc, "echo", "--of", "all", "--json"], env=environment, stdout=subprocess.DEVNULL) for _ in range(watchers)]
        time.sleep(0.5)
        start = time.monotonic()
        while subprocess.run([mrroc, "start"], env=environment, capture_output=True, check=False).returncode == 1:
            time.sleep(0.05)
        command.wait()
        seconds = time.monotonic() - start
        for echo in echoes:
            echo.wait()
    return seconds, subprocess.run([mrroc, "trace", "hash", trace], capture_output=True, text=True, check=True).stdout.strip()


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("build", nargs="?", default="build")
    arguments.add_argument("--pairs", type=int, default=7)
    arguments.add_argument("--watchers", type=int, default=1)
    given = arguments.parse_args()
    mrroc = str(pathlib.Path(given.build).resolve() / "bin/mrroc")
    ratios, hashes = [], set()
    for pair in range(given.pairs):
        times = {}
        for watchers in ((0, given.watchers) if pair % 2 == 0 else (given.watchers, 0)):
            with tempfile.TemporaryDirectory() as folder:
                times[watchers], trace = run(mrroc, folder, watchers)
                hashes.add(trace)
        ratios.append(times[given.watchers] / times[0])
        print(f"pair {pair + 1}: {times[0]:.2f} s alone, {times[given.watchers]:.2f} s with {given.watchers} watchers, ratio {ratios[-1]:.2f}", flush=True)
    print(f"ratio {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})")
    print("all traces are equal" if len(hashes) == 1 else f"traces differ: {sorted(hashes)}")
    return 0 if len(hashes) == 1 else 1


sys.exit(main())
