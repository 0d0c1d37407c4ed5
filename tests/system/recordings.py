"""What the tests of recordings share: runs of deployments, and their recordings as independent readers see them.

The program's arguments are BUILD_FOLDER SOURCE_FOLDER [NAME]: all its tests, or this one.
"""

import hashlib
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from rosbags.highlevel import AnyReader

BUILD, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
MRROC = BUILD / "bin/mrroc"
PRESS = SOURCE / "tasks/press/press.toml"
PICK = SOURCE / "tasks/pick/pick.toml"

PERIOD = 2_000_000  # ns, of the tasks' servos
JOINTS = {  # as in the URDFs
    "arm": ["column", "lower_arm", "upper_arm", "wrist_pitch", "wrist_roll", "tool_roll"],
    "gripper": ["opening"],
}


def mrroc(*words, expected=0, delay=None):
    """Its output, and its errors. `delay`: s for which the disk does not take the recording."""
    environment = dict(os.environ)
    if delay is not None:  # a sanitizer wants to be loaded first
        environment |= {"LD_PRELOAD": str(BUILD / "tests/slow_disk.so"), "MRROC_TEST_DISK_DELAY": str(delay), "ASAN_OPTIONS": "verify_asan_link_order=0"}
    done = subprocess.run([MRROC, *map(str, words)], capture_output=True, text=True, cwd=SOURCE, timeout=300, check=False, env=environment)
    assert done.returncode == expected, f"{words}: exit code {done.returncode}, expected {expected}\n{done.stdout}{done.stderr}"
    return done.stdout, done.stderr


def run(deployment, folder, name, *words, expected=0, delay=None):
    """A lockstep run with a recording: its file."""
    recording = folder / f"{name}.mcap"
    mrroc("run", deployment, "--quiet", "--clock", "lockstep", "--black-box", "", "--record", recording, *words, expected=expected, delay=delay)
    return recording


def sha(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


def messages(recording):
    """As rosbags decodes them, by topic: (time in ns, message)."""
    found = {}
    with AnyReader([recording]) as reader:
        for connection, stamp, raw in reader.messages():
            found.setdefault(connection.topic, []).append((stamp, reader.deserialize(raw, connection.msgtype)))
    return found


def same(value, own):
    """Whether a value of rosbags is that of our JSON, to the last bit."""
    if isinstance(own, dict):
        fields = {name for name in vars(value) if name.islower()} - {"__msgtype__"}  # constants are upper case
        return own.keys() == fields and all(same(getattr(value, name), part) for name, part in own.items())
    if isinstance(own, list):
        return len(own) == len(value) and all(map(same, value, own))
    if isinstance(own, float):
        return value == own and math.copysign(1, value) == math.copysign(1, own)
    return not math.isfinite(value) if own is None else value == own


def check_same_as_json(recording, found):
    """What `mrroc trace cat` prints is what rosbags reads: every message, in its order among those of its topic."""
    printed = {}
    for line in mrroc("trace", "cat", recording)[0].splitlines():
        entry = json.loads(line, parse_int=float)  # -0 has a sign
        printed.setdefault(entry["topic"], []).append(entry)
    assert printed.keys() == found.keys(), f"{printed.keys()}, expected {found.keys()}"
    for topic, entries in printed.items():
        assert len(entries) == len(found[topic]), f"{topic}: {len(entries)} messages, expected {len(found[topic])}"
        for entry, (time_ns, message) in zip(entries, found[topic]):
            assert entry["time"] == time_ns / 1e9 and entry["type"] == message.__msgtype__, f"{topic}: {entry}"
            assert same(message, entry["message"]), f"{topic}, {time_ns} ns: {entry['message']}, expected {message}"


def nanoseconds(stamp):
    return stamp.sec * 1_000_000_000 + stamp.nanosec


def run_tests(tests):
    """Those functions of a module (`globals()`) whose names begin with test_, each with a folder of its own."""
    for test in [test for name, test in tests.items() if name.startswith("test_")]:
        if sys.argv[3:] and test.__name__ not in sys.argv[3:]:
            continue
        with tempfile.TemporaryDirectory() as folder:
            os.environ["MRROC_RUNTIME_DIR"] = f"{folder}/mrroc"  # the only run is that of the test
            began = time.monotonic()
            test(pathlib.Path(folder))
            print(f"{test.__name__}: {time.monotonic() - began:.1f} s", flush=True)

