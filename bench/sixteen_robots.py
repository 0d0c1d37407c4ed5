"""Sixteen robots at 500 Hz on one machine under the real clock, without and with a recording of every servo tick, in pairs.

sixteen_robots.py [BUILD_DIR] [--pairs N]: prints, of each run, the ticks of all servos, those missed, late commands, and the median and
the worst p99 of a tick's duration; in runs with a recording also what was dropped, and the size of the file. Beside it the baseline: how
often a bare loop of 500 Hz on each processor, with the highest real-time priority, began a tick after the end of
its period. Such a stand of the machine costs each robot a tick. Without the right to real-time priority there is no such baseline: the
loop would wait for the robots.
"""

import argparse
import multiprocessing
import os
import pathlib
import re
import statistics
import subprocess
import tempfile
import time

ROBOT = '[robots.r{}]\ntype = "irb6"\nprogram = "irb6_demo"\nhardware = "loopback"\n'
DEPLOYMENT = '[deployment]\nname = "sixteen"\nclock = "real"\n' + "".join(ROBOT.format(number) for number in range(1, 17))
PERIOD = 0.002  # s
LINE = re.compile(r"_edp +(\d+) ticks, (\d+) missed, (\d+) late commands;.*tick p50 (\d+) p99 (\d+)")


def metronome(processor, end, late):
    """Counts in `late` the ticks that begin more than a period behind time, until `end` is set; -1 without real-time priority."""
    os.sched_setaffinity(0, {processor})
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(99))
    except PermissionError:
        late.value = -1
        return
    due = time.monotonic()
    while not end.is_set():
        due += PERIOD
        time.sleep(max(0, due - time.monotonic()))
        while time.monotonic() > due + PERIOD:
            late.value += 1
            due += PERIOD


def stands_during(work):
    """What `work` returns, and for each processor how many ticks a bare loop has missed meanwhile."""
    end = multiprocessing.Event()
    counts = [(processor, multiprocessing.Value("i", 0)) for processor in sorted(os.sched_getaffinity(0))]
    loops = [multiprocessing.Process(target=metronome, args=(processor, end, late)) for processor, late in counts]
    for loop in loops:
        loop.start()
    try:
        return work(), [late.value for _, late in counts]
    finally:
        end.set()
        for loop in loops:
            loop.join()


def run(mrroc, folder, recorded):
    deployment, recording = folder / "sixteen.toml", folder / "sixteen.mcap"
    deployment.write_text(DEPLOYMENT, encoding="utf-8")
    words = ["--record", recording, "--record-rate", "servo"] if recorded else []
    command = [mrroc, "run", deployment, "--black-box=", *words]
    done, stands = stands_during(lambda: subprocess.run(command, capture_output=True, text=True, check=True))
    rows = [tuple(map(int, row)) for row in LINE.findall(done.stdout)]
    if len(rows) != 16:
        raise RuntimeError(f"{len(rows)} robots have reported\n{done.stdout}")
    ticks, missed, late, p50, p99 = zip(*rows)
    text = f"{sum(ticks)} ticks, {sum(missed)} missed, {sum(late)} late commands; tick p50 {statistics.median(p50)} us, p99 {max(p99)} us at worst"
    if recorded:
        dropped = re.search(r"lacks (.*): the disk", done.stdout + done.stderr)
        text += f"; {dropped[0] if dropped else 'nothing dropped'}, {recording.stat().st_size / 1e6:.1f} MB"
    return text if -1 in stands else f"{text}; a bare loop has missed {' + '.join(map(str, stands))}"


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("build", nargs="?", default="build")
    arguments.add_argument("--pairs", type=int, default=3)
    given = arguments.parse_args()
    mrroc = pathlib.Path(given.build).resolve() / "bin/mrroc"
    for _ in range(given.pairs):
        for recorded in (False, True):
            with tempfile.TemporaryDirectory() as folder:
                print(f"{'recorded' if recorded else 'alone':9}{run(mrroc, pathlib.Path(folder), recorded)}", flush=True)


if __name__ == "__main__":
    main()
