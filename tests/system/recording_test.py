"""`mrroc run --record`: equal runs have equal recordings; independent readers of MCAP and CDR (mcap, rosbags) read in them
what `mrroc trace cat` prints; a full disk and a killed run leave the rest whole.

Usage: recording_test.py BUILD_FOLDER SOURCE_FOLDER [NAME]: all tests, or this one
"""

import json
import pathlib
import re
import signal
import subprocess
import sys
import time

from mcap.reader import make_reader
from mcap.stream_reader import StreamReader
from mcap.records import Message

from recordings import JOINTS, MRROC, PERIOD, PICK, PRESS, SOURCE, check_same_as_json, messages, mrroc, nanoseconds, run, run_tests, sha


def check_steps(recording, found):
    """By an independent reader: what our own reader prints, and the times of the steps."""
    check_same_as_json(recording, found)
    steps = [message for topic, entries in found.items() if topic.endswith("/steps") for _, message in entries]
    assert all(nanoseconds(step.stamp) == step.tick * PERIOD for step in steps)
    states = sum(len(step.robots) for step in steps)
    assert states > 100, f"{states} states"
    assert f": {len(steps)} steps of " in mrroc("trace", "check", recording)[0]


def check_standard_messages(found, robots, wrenches):
    for robot in robots:
        newest = -1
        states = {state.tick: state for topic, steps in found.items() if topic.endswith("/steps") for _, step in steps
                  for state in step.robots if state.name == robot}
        for time_ns, message in found[f"/{robot}/joint_states"]:
            stamp = nanoseconds(message.header.stamp)
            assert newest < stamp <= time_ns, f"{robot}: a state of {stamp} ns at {time_ns} ns after {newest} ns"
            newest = stamp
            state = states[stamp // PERIOD]
            assert list(message.position) == list(state.joints) and list(message.name) == JOINTS[robot]
    for sensor in wrenches:
        readings = {reading.tick: reading for topic, steps in found.items() if topic.endswith("/steps") for _, step in steps
                    for reading in step.sensors if reading.name == sensor}
        recorded = found[f"/{sensor}/wrench"]
        assert len(recorded) > 50
        for _, message in recorded:
            values = list(readings[nanoseconds(message.header.stamp) // PERIOD].values)
            force, torque = message.wrench.force, message.wrench.torque
            assert [force.x, force.y, force.z, torque.x, torque.y, torque.z] == values
            assert message.header.frame_id == sensor


def check_container(recording, deployment):
    """Profile, schemas, encodings, order, index and what is attached, by the mcap package."""
    with recording.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        assert reader.get_header().profile == "ros2"
        summary = reader.get_summary()
        assert all(schema.encoding == "ros2msg" for schema in summary.schemas.values())
        assert all(channel.message_encoding == "cdr" for channel in summary.channels.values())
        assert all(channel.schema_id in summary.schemas for channel in summary.channels.values())
        count = sum(1 for _ in reader.iter_messages())
        assert count == summary.statistics.message_count > 0
        assert all(index.message_end_time - index.message_start_time <= 1_000_000_000 for index in summary.chunk_indexes)
        attached = {attachment.name: attachment.data for attachment in reader.iter_attachments()}
        assert attached == {"deployment.toml": deployment.read_bytes()}
        metadata = {record.name: record.metadata for record in reader.iter_metadata()}
        assert metadata["mrroc"]["deployment"] == deployment.stem and metadata["mrroc"]["clock"] == "lockstep"
        assert metadata["mrroc"]["version"] in mrroc("--version")[0]
    with recording.open("rb") as stream:
        times = [record.log_time for record in StreamReader(stream).records if isinstance(record, Message)]
    assert times == sorted(times) and len(times) == count


def motion_of_task(file, found):
    """The lines of --motion up to the last step of press; how many follow depends on how long the processes take to leave."""
    last = found["/arm/steps"][-1][1].tick
    lines = [line for line in file.read_text(encoding="ascii").splitlines() if line[0] != "#" and int(line.split()[0]) <= last]
    assert len(lines) == last > 4000, f"{file}: {len(lines)} ticks, expected {last}"
    return lines


def test_equal_runs(folder):
    """press, one process with a sensor: equal bytes, and the robot moves as in a run that is not recorded."""
    plain, moved = folder / "plain.motion", folder / "recorded.motion"
    mrroc("run", PRESS, "--quiet", "--clock", "lockstep", "--black-box", "", "--motion", plain)
    recording, again = (run(PRESS, folder, f"press{i}", "--motion", moved) for i in range(2))
    assert sha(recording) == sha(again), "two runs, two recordings"
    found = messages(recording)
    assert motion_of_task(moved, found) == motion_of_task(plain, found), "the recording changes the run"
    check_steps(recording, found)
    check_standard_messages(found, ["arm"], ["wrist"])
    check_container(recording, PRESS)
    kinds = [(event.kind, event.tick, event.exit_code) for _, event in found["/events"]]
    assert kinds[0] == ("operator", 0, 0) and kinds[-1][0] == "end" and kinds[-1][2] == 0, kinds
    print(f"press: {recording.stat().st_size} bytes, SHA-256 {sha(recording)}")


def test_several_processes(folder):
    """pick, an MP and two ECPs: the order of their messages is that of their ticks and names, in every run."""
    recording, again = (run(PICK, folder, f"pick{i}") for i in range(2))
    assert sha(recording) == sha(again), "two runs, two recordings"
    found = messages(recording)
    check_steps(recording, found)
    check_standard_messages(found, ["arm", "gripper"], [])
    check_container(recording, PICK)
    assert {end.process for _, end in found["/process_ends"]} == {"mp", "arm", "gripper"}


def test_events(folder):
    """The operator's commands have the ticks at which they take effect."""
    events = folder / "events.toml"
    events.write_text('[[events]]\ntick = 300\ncommand = "pause"\n\n[[events]]\ntick = 500\ncommand = "resume"\n\n'
                      '[[events]]\ntick = 700\ncommand = "speed"\nvalue = 50\n', encoding="utf-8")
    first, second = (run(PRESS, folder, f"events{i}", "--events", events) for i in range(2))
    assert sha(first) == sha(second)
    found = [(event.tick, event.text) for _, event in messages(first)["/events"] if event.kind == "operator"]
    assert [tick for tick, _ in found] == [0, 300, 500, 700], found
    # what is recorded can be given to --events again
    again = folder / "again.toml"
    again.write_text("".join(text for _, text in found), encoding="utf-8")
    assert sha(run(PRESS, folder, "again", "--events", again)) == sha(first)


def test_difference(folder):
    """Two equal runs, and two that differ from tick 700 on: the first difference is named."""
    recording, equal = (run(PRESS, folder, name) for name in ("one", "equal"))
    assert "equal: 474 steps" in mrroc("trace", "diff", recording, equal)[0]
    events = folder / "events.toml"
    events.write_text('[[events]]\ntick = 700\ncommand = "speed"\nvalue = 50\n', encoding="utf-8")
    slower = run(PRESS, folder, "other", "--events", events)
    found = mrroc("trace", "diff", recording, slower, expected=1)[0]
    tick = int(re.match(r"process arm, instruction \d+ \(.+\), step \d+, tick (\d+): .+ of robot arm", found).group(1))
    assert 690 <= tick <= 760, found


def test_killed_process(folder):
    """A task that is killed: its steps up to then, the fault and the outcome are recorded."""
    recording, again = (run(PRESS, folder, f"killed{i}", "--inject", "kill ecp:arm at step 120", expected=4) for i in range(2))
    assert sha(recording) == sha(again)
    found = messages(recording)
    assert len(found["/arm/steps"]) == 120
    kinds = {event.kind: event for _, event in found["/events"]}
    assert kinds["fault"].text == "kill ecp:arm at step 120"
    assert kinds["end"].exit_code == 4 and "arm" in kinds["end"].text, kinds["end"]
    assert "arm" not in {end.process for _, end in found.get("/process_ends", [])}
    assert "it was killed" in mrroc("trace", "check", recording)[0]


def test_full_disk(folder):
    """The run continues to its end as with a disk that has room, and the reason is reported."""
    full, plain = folder / "full.motion", folder / "plain.motion"
    _, errors = mrroc("run", PRESS, "--quiet", "--clock", "lockstep", "--black-box", "", "--motion", full, "--record", "/dev/full", expected=4)
    assert "cannot write the recording /dev/full: No space left on device" in errors, errors
    found = messages(run(PRESS, folder, "plain", "--motion", plain))
    assert motion_of_task(full, found) == motion_of_task(plain, found)


def test_killed_run(folder):
    """SIGKILL of the runner: all but the last second of the recording is readable, by every reader."""
    recording = folder / "cut.mcap"
    runner = subprocess.Popen([MRROC, "run", PRESS, "--quiet", "--clock", "paced", "--record", recording], cwd=SOURCE,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    try:
        deadline = time.monotonic() + 60
        # three seconds of the run's time
        while time.monotonic() < deadline and newest_step(recording) < 3_000_000_000:
            assert runner.poll() is None, "the run has ended"
            time.sleep(0.1)
    finally:
        runner.send_signal(signal.SIGKILL)
        runner.wait()
    assert newest_step(recording) >= 3_000_000_000, "no three seconds in the recording"
    lines, note = mrroc("trace", "cat", recording)
    parsed = [json.loads(line) for line in lines.splitlines()]
    assert max(line["time"] for line in parsed if line["topic"] == "/arm/steps") >= 3
    assert "ends early: the run was killed" in note
    assert "it was killed" in mrroc("trace", "check", recording)[0]


def newest_step(recording):
    """Time of the last message that a reader without index finds, ns."""
    newest = -1
    try:
        with recording.open("rb") as stream:
            for record in StreamReader(stream).records:
                if isinstance(record, Message):
                    newest = max(newest, record.log_time)
    except Exception:  # pylint: disable=broad-except: the file ends anywhere
        pass
    return newest


def test_real_clock(folder):
    """Under the real clock too: nothing is dropped, and every reader finds the same."""
    deployment = folder / "short.toml"
    deployment.write_text('[deployment]\nname = "short"\nclock = "real"\n[robots.arm]\ntype = "irb6"\nprogram = "irb6_demo"\n'
                          'hardware = "loopback"\n', encoding="utf-8")
    recording = folder / "real.mcap"
    mrroc("run", deployment, "--quiet", "--record", recording)
    found = messages(recording)
    check_steps(recording, found)
    ends = [end for _, end in found["/process_ends"] if end.process == "arm"]
    assert len(ends) == 1 and ends[0].steps == len(found["/arm/steps"]) and ends[0].dropped == 0


def test_refusals(folder):
    """Before anything starts; and files that are not recordings."""
    text = folder / "text"
    assert "is also the file of --motion" in mrroc("run", PRESS, "--motion", text, "--record", text, expected=2)[1]
    assert "is also the file of deployment" in mrroc("run", PRESS, "--record", PRESS, expected=2)[1]
    assert "cannot write the recording" in mrroc("run", PRESS, "--record", folder / "none/r.mcap", expected=2)[1]
    text.write_text("no recording\n", encoding="utf-8")
    assert "is not an MCAP file, expected a recording" in mrroc("trace", "cat", text, expected=2)[1]
    assert "cannot read the recording" in mrroc("trace", "cat", folder / "none", expected=2)[1]
    whole = run(PRESS, folder, "damaged")
    signal, picture = "/arm/joint_states/position[0]", folder / "picture.png"
    assert "--output" in mrroc("trace", "plot", whole, signal, "-o", picture, expected=2)[1] and not picture.exists()
    assert "--from" in mrroc("trace", "plot", whole, signal, "--from", "8", "--to", "3", expected=2)[1]
    content = bytearray(whole.read_bytes())
    content[len(content) // 2] ^= 0xFF
    whole.write_bytes(content)
    assert f"{whole}: byte " in mrroc("trace", "check", whole, expected=2)[1]


def test_page(folder):
    """The program of docs/reference/recording.md prints the rise of the force."""
    page = (SOURCE / "docs/reference/recording.md").read_text(encoding="utf-8")
    program = re.search(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL).group(1)
    recording = run(PRESS, folder, "page")
    assert "build/press.mcap" in program
    program = program.replace("build/press.mcap", str(recording))
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    rows = [tuple(map(float, row.split())) for row in done.stdout.splitlines()]
    assert rows == sorted(rows, key=lambda row: row[0]) and max(abs(force) for _, force in rows) > 8, rows[-5:]


if __name__ == "__main__":
    run_tests(globals())
