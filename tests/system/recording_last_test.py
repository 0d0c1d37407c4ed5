"""`mrroc run --record-last`: the last seconds of a run are written when it fails or the operator asks, and at no other
time.

Usage: recording_last_test.py BUILD_FOLDER SOURCE_FOLDER [NAME]: all tests, or this one
"""

import json
import subprocess
import time

from recordings import MRROC, PRESS, SOURCE, messages, mrroc, run, run_tests, sha

LAST = ["--record-last", "2"]
KILL = ["--inject", "kill ecp:arm at step 400"]


def span(recording):
    """First and last time of the messages, s, and their topics."""
    times = [(json.loads(line)["time"], json.loads(line)["topic"]) for line in mrroc("trace", "cat", recording)[0].splitlines()]
    return times[0][0], times[-1][0], {topic for _, topic in times}


def test_success(folder):
    """Nothing is written, and a file of an earlier run stays as it is."""
    recording = run(PRESS, folder, "good", *LAST)
    assert not recording.exists()
    recording.write_bytes(b"\x89MCAP0\r\nearlier")
    run(PRESS, folder, "good", *LAST)
    assert recording.read_bytes() == b"\x89MCAP0\r\nearlier"


def test_failure(folder):
    """The end of the run, the same as in a recording of all of it; two runs have the same file."""
    whole = messages(run(PRESS, folder, "whole", *KILL, expected=4))
    recordings = [run(PRESS, folder, f"failed{i}", *LAST, *KILL, expected=4) for i in range(2)]
    assert sha(recordings[0]) == sha(recordings[1])
    first, last, _ = span(recordings[0])
    assert last > 4 and last - 2.001 <= first <= last - 1.9, (first, last)
    assert "rules hold" in mrroc("trace", "check", recordings[0])[0]
    found = messages(recordings[0])
    for topic in ("/arm/steps", "/arm/joint_states", "/wrist/wrench"):
        expected = [stamp for stamp, _ in whole[topic] if stamp >= (last - 2) * 1e9]
        assert [stamp for stamp, _ in found[topic]] == expected, topic
    assert found["/events"][-1][1].kind == "end" and found["/events"][-1][1].exit_code == 4


def test_servo_ticks(folder):
    """With the ticks of the servo, too: the last two seconds of them."""
    recording = run(PRESS, folder, "servo", *LAST, "--record-rate", "servo", *KILL, expected=4)
    ticks = [message.tick for _, message in messages(recording)["/arm/servo"]]
    assert 990 <= len(ticks) <= 1000 and ticks == list(range(ticks[0], ticks[-1] + 1)), (len(ticks), ticks[:1])


def test_verb(folder):
    """`mrroc record` writes the last seconds while the run continues, each time to a new file."""
    runner = subprocess.Popen([MRROC, "run", PRESS, "--quiet", "--clock", "paced", "--record", folder / "end.mcap", *LAST], cwd=SOURCE,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    try:
        wanted, deadline = folder / "now.mcap", time.monotonic() + 60
        # three seconds of the run's time
        while time.monotonic() < deadline:
            assert runner.poll() is None, "the run has ended"
            wanted.unlink(missing_ok=True)
            done = subprocess.run([MRROC, "record", wanted], capture_output=True, text=True, cwd=folder, timeout=30, check=False)
            if done.returncode == 0 and span(wanted)[1] > 3:
                break
            time.sleep(0.2)
        first, last, topics = span(wanted)
        assert last > 3 and last - 2.001 <= first <= last - 1.9 and "/arm/steps" in topics, (first, last)
        assert "the last 2 s; recording: " + str(wanted) in done.stdout, done.stdout
        again = subprocess.run([MRROC, "record", wanted], capture_output=True, text=True, timeout=30, check=False)
        assert again.returncode == 2 and str(wanted) in again.stdout + again.stderr, again
        assert "rules hold" in mrroc("trace", "check", wanted)[0]
        assert runner.wait(timeout=120) == 0
    finally:
        runner.kill()
        runner.wait()
    assert not (folder / "end.mcap").exists()


def test_full_disk(folder):
    """The reason of the failure stays, and the missing recording is reported."""
    _, errors = mrroc("run", PRESS, "--quiet", "--clock", "lockstep", "--black-box", "", "--record", "/dev/full", *LAST, *KILL, expected=4)
    assert "cannot write the recording /dev/full: No space left on device" in errors and "arm died" in errors, errors


def test_refusals(folder):
    """Seconds without a file, and no seconds."""
    assert "--record" in mrroc("run", PRESS, *LAST, expected=2)[1]
    for seconds in ("0", "-1", "nan", "two", "1e9"):
        assert "--record-last" in mrroc("run", PRESS, "--record", folder / "r.mcap", "--record-last", seconds, expected=2)[1]
    assert not (folder / "r.mcap").exists()


if __name__ == "__main__":
    run_tests(globals())
