"""What watchers cost a run: `press` in lockstep without and with watchers of all states, in pairs, and the hashes of their
recordings.

telemetry.py [BUILD_DIR] [--pairs N] [--watchers N]: prints the ratio of the times (median and range over the pairs), and whether all
hashes are equal. The watchers' own time is in it: they share the processors.
"""

import argparse
import contextlib
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

DEPLOYMENT = pathlib.Path(__file__).resolve().parent.parent / "tasks/press/press.toml"
START = 40000  # ticks: the watchers have joined, and the runs have the same ticks


def run(mrroc, folder, watchers):
    """Seconds of wall time from the first answer of the run to its end, and the hash of its steps."""
    environment = {**os.environ, "MRROC_RUNTIME_DIR": f"{folder}/run"}
    recording, events = f"{folder}/run.mcap", pathlib.Path(folder) / "start.toml"
    events.write_text(f'[[events]]\ntick = {START}\ncommand = "start"\n', encoding="utf-8")
    with contextlib.ExitStack() as stack:
        command = stack.enter_context(subprocess.Popen(
            [mrroc, "run", DEPLOYMENT, "--clock", "lockstep", "--hold", "--events", events, "--quiet", "--black-box=", "--record", recording],
            env=environment, stdout=subprocess.DEVNULL))
        while subprocess.run([mrroc, "status"], env=environment, capture_output=True, check=False).returncode != 0:
            if command.poll() is not None:
                raise RuntimeError(f"the run ended with {command.returncode} before it answered")
            time.sleep(0.01)
        start = time.monotonic()
        for _ in range(watchers):
            stack.enter_context(subprocess.Popen([mrroc, "echo", "--of", "all", "--json"], env=environment, stdout=subprocess.DEVNULL))
        code = command.wait()
        seconds = time.monotonic() - start
    if code != 0:
        raise RuntimeError(f"the run ended with {code}")
    return seconds, subprocess.run([mrroc, "trace", "hash", recording], capture_output=True, text=True, check=True).stdout.strip()


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
                times[watchers], found = run(mrroc, folder, watchers)
                hashes.add(found)
        ratios.append(times[given.watchers] / times[0])
        print(f"pair {pair + 1}: {times[0]:.2f} s alone, {times[given.watchers]:.2f} s with {given.watchers} watchers, ratio {ratios[-1]:.2f}", flush=True)
    print(f"ratio {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})")
    print("all hashes are equal" if len(hashes) == 1 else f"hashes differ: {sorted(hashes)}")
    return 0 if len(hashes) == 1 else 1


sys.exit(main())
