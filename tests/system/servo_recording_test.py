"""`mrroc run --record --record-rate servo`: every tick of every servo is recorded, agrees with the steps of the run, and
is the same in every lockstep run; the run does not change.

Usage: servo_recording_test.py BUILD_FOLDER SOURCE_FOLDER [NAME]: all tests, or this one
"""

import re

from recordings import JOINTS, PERIOD, PICK, PRESS, check_same_as_json, messages, mrroc, nanoseconds, run, run_tests, sha

SERVO = ["--record-rate", "servo"]
ON = 4


def hash_of(recording):
    return mrroc("trace", "hash", recording)[0].split()[0]


def ticks_of(found, robot):
    """The servo's ticks, each there once and in order; its last message counts them."""
    ticks = [message for _, message in found[f"/{robot}/servo"]]
    assert [message.tick for message in ticks] == list(range(len(ticks))), f"{robot}: ticks are missing or doubled"
    assert all(time == message.tick * PERIOD for time, message in found[f"/{robot}/servo"])
    ends = [end for _, end in found["/servo_ends"] if end.robot == robot]
    assert [(end.ticks, end.dropped) for end in ends] == [(len(ticks), 0)]
    return ticks


def check_agrees_with_steps(found, robot, ticks):
    """The states that the task saw are those of the servo at the same tick; so are the standard messages."""
    seen = 0
    for topic, steps in found.items():
        if not topic.endswith("/steps"):
            continue
        for state in (state for _, step in steps for state in step.robots if state.name == robot):
            if state.tick >= len(ticks):  # of the tick in which the task ended
                assert state.tick == len(ticks)
                continue
            assert list(state.joints) == list(ticks[state.tick].joints), f"{topic}: tick {state.tick}"
            seen += 1
    assert seen > 50, f"{seen} states"
    states = [message for _, message in found[f"/{robot}/joint_states"]]
    assert len(states) == len(ticks)
    for state, tick in zip(states, ticks):
        assert list(state.name) == JOINTS[robot] and state.header.stamp == tick.stamp
        assert list(state.position) == list(tick.joints) and list(state.velocity) == list(tick.velocity)


def test_press(folder):
    """One arm with a force sensor: two runs, one with a slow disk, one recording; the force rises within single ticks."""
    steps_only = run(PRESS, folder, "steps")
    recording, delayed = (run(PRESS, folder, f"press{i}", *SERVO, delay=delay) for i, delay in enumerate((None, 4)))
    assert sha(recording) == sha(delayed), "two runs, two recordings"
    assert hash_of(recording) == hash_of(steps_only), "the ticks change the steps"
    assert "rules hold" in mrroc("trace", "check", recording)[0]
    found = messages(recording)
    check_same_as_json(recording, found)
    ticks = ticks_of(found, "arm")
    check_agrees_with_steps(found, "arm", ticks)
    assert ticks[-1].state == ON and all(tick.fault == "" for tick in ticks)
    assert all(nanoseconds(tick.stamp) == tick.tick * PERIOD and tick.ahead == 0 for tick in ticks)
    moving = [tick for tick in ticks if max(abs(tick.velocity)) > 0.05]
    assert len(moving) > 500
    worst = max(max(abs(tick.joints - tick.desired_joints)) for tick in moving)
    assert 0 < worst < 0.05, f"following error {worst} rad"
    assert max(max(abs(tick.current)) for tick in moving) > 0.1
    print(f"press: {len(ticks)} ticks, {recording.stat().st_size} bytes, SHA-256 {sha(recording)}")


def test_robots(folder):
    """pick, an arm and a gripper: one topic for each robot, ordered by tick and name among the steps."""
    recording, again = (run(PICK, folder, f"pick{i}", *SERVO) for i in range(2))
    assert sha(recording) == sha(again), "two runs, two recordings"
    found = messages(recording)
    for robot in ("arm", "gripper"):
        check_agrees_with_steps(found, robot, ticks_of(found, robot))


def test_fault(folder):
    """The tick of a drive's fault is in the recording, and what the servo did in it."""
    recording = run(PRESS, folder, "fault", *SERVO, "--inject", "fault edp:arm at step 100", expected=3)
    found = messages(recording)
    ticks = ticks_of(found, "arm")
    faulty = [tick for tick in ticks if tick.fault]
    assert faulty and faulty[0].fault == "a drive reports a fault", faulty[:1]
    before, after = ticks[faulty[0].tick - 1], ticks[faulty[0].tick]
    assert before.state == ON and after.state != ON
    event = next(event for _, event in found["/events"] if event.kind == "fault")
    assert 0 <= faulty[0].tick - event.tick <= 1


def test_killed_edp(folder):
    """The ticks up to the kill are there; the last message of the servo is missing."""
    recording = run(PRESS, folder, "killed", *SERVO, "--inject", "kill edp:arm at step 100", expected=4)
    found = messages(recording)
    assert "/servo_ends" not in found
    ticks = [message.tick for _, message in found["/arm/servo"]]
    event = next(event for _, event in found["/events"] if event.kind == "fault")
    assert ticks == list(range(len(ticks))) and event.tick - 2 <= ticks[-1] <= event.tick + 1, (ticks[-1], event.tick)


def real_arm(folder):
    """A deployment of one arm under the real clock."""
    deployment = folder / "short.toml"
    deployment.write_text('[deployment]\nname = "short"\nclock = "real"\n[robots.arm]\ntype = "irb6"\nprogram = "irb6_demo"\n'
                          'hardware = "loopback"\n', encoding="utf-8")
    return deployment


def test_slow_disk(folder):
    """No process waits for a disk that stands still: what finds no room is dropped and counted, and the file is whole."""
    deployment, recording = real_arm(folder), folder / "slow.mcap"
    output, _ = mrroc("run", deployment, "--record", recording, *SERVO, delay=4)
    ran = int(re.search(r"arm_edp +(\d+) ticks", output)[1])
    found = messages(recording)
    ticks = [message.tick for _, message in found["/arm/servo"]]
    servo = found["/servo_ends"][-1][1]
    assert ticks == sorted(set(ticks)) and servo.ticks == len(ticks)
    # the report has the counts of the last status, some ticks before the end
    assert servo.ticks + servo.dropped >= ran > 1000, (servo.ticks, servo.dropped, ran)
    task = next(end for _, end in found["/process_ends"] if end.process == "arm")
    assert task.steps == len(found["/arm/steps"]) > 100 and task.dropped > 0
    assert f"lacks {task.dropped} steps of arm" in output, output
    print(f"slow disk: {task.dropped} steps and {servo.dropped} ticks dropped")


def test_real_clock(folder):
    """Under the real clock nothing is dropped; a tick that the servo missed has no message."""
    deployment = real_arm(folder)
    recording = folder / "real.mcap"
    mrroc("run", deployment, "--quiet", "--record", recording, *SERVO)
    found = messages(recording)
    ticks = [message.tick for _, message in found["/arm/servo"]]
    assert ticks == sorted(set(ticks)) and len(ticks) > 1000
    assert [(end.ticks, end.dropped) for _, end in found["/servo_ends"]] == [(len(ticks), 0)]


def test_refusals(_):
    """A rate without a recording, and a rate that there is not."""
    assert "--record" in mrroc("run", PRESS, "--record-rate", "servo", expected=2)[1]
    assert "sensor" in mrroc("run", PRESS, "--record", "r.mcap", "--record-rate", "sensor", expected=2)[1]


if __name__ == "__main__":
    run_tests(globals())
