"""What the tests of recordings share: runs of deployments, and their recordings as independent readers see them.

The program's arguments are BUILD_FOLDER SOURCE_FOLDER [NAME]: all its tests, or this one.
"""

import hashlib
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
sys.path.insert(0, str(SOURCE / "scripts"))  # of mrroc_trace

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
    """A lockstep run with trace and recording: their files, and its errors."""
    trace, recording = folder / f"{name}.trace", folder / f"{name}.mcap"
    _, errors = mrroc("run", deployment, "--quiet", "--clock", "lockstep", "--black-box", "", "--trace", trace, "--record", recording,
                      *words, expected=expected, delay=delay)
    return trace, recording, errors


def sha(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


def messages(recording):
    """As rosbags decodes them, by topic: (time in ns, message)."""
    found = {}
    with AnyReader([recording]) as reader:
        for connection, stamp, raw in reader.messages():
            found.setdefault(connection.topic, []).append((stamp, reader.deserialize(raw, connection.msgtype)))
    return found


def nanoseconds(stamp):
    return stamp.sec * 1_000_000_000 + stamp.nanosec


def run_tests(tests):
    """Those functions of a module (`globals()`) whose names begin with test_, each with a folder of its own."""
    for test in [test for name, test in tests.items() if name.startswith("test_")]:
        if sys.argv[3:] and test.__name__ not in sys.argv[3:]:
            continue
        with tempfile.TemporaryDirectory() as folder:
            began = time.monotonic()
            test(pathlib.Path(folder))
            print(f"{test.__name__}: {time.monotonic() - began:.1f} s", flush=True)

