"""mrroc_trace reads every step of a recording, and reports a malformed message or a failure of the program with the file and the reason.

mrroc_trace_test.py MRROC_BINARY SOURCE_FOLDER
"""

import contextlib
import copy
import io
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

MRROC, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(SOURCE / "scripts"))
import mrroc_trace

POSE = {"position": {"x": 0.75, "y": 0, "z": -1.5e-05}, "orientation": {"x": 1, "y": 2, "z": 3, "w": 4}}
COMMAND = {"kind": 3, "relative": False, "interpolation": 0, "motion_steps": 10, "reply_step": 8, "start_tick": 0,
           "target": [0.75, 0, 0.1, 1, 0, 0, 0], "behaviour": ""}
ARM = {"name": "arm", "tick": 248, "macrostep_start": 240, "joints": [0.5, -1], "pose": POSE, "desired_tick": 250,
       "desired_joints": [0.25, -1], "desired_pose": POSE, "moving": True, "late_commands": 0, "wrench": [], "lost": 0, "error_class": 0,
       "error": "", "command": [COMMAND]}
WRIST = {"name": "wrist", "tick": 248, "values": [0.5, 2], "period": 1, "mode": 0, "error_class": 0, "error": ""}
STEP = {"tick": 248, "process": "arm", "instruction": 4, "is_move": True, "name": "ToolVelocity", "until": ["force above 10 N"],
        "step_number": 12, "held": 0, "robots": [ARM], "sensors": [WRIST], "conditions": [{"name": "force above 10 N", "holds": False}],
        "ending": 0, "skew": [], "cut": False}
ENTRY = {"time": 0.496, "topic": "/arm/steps", "type": "mrroc_msgs/msg/Step", "message": STEP}
OTHER = {"time": 0.5, "topic": "/events", "type": "mrroc_msgs/msg/Event", "message": {}}


def constants_of(message):
    """Names of the constants of a message, in lower case, in their order."""
    text = (SOURCE / f"src/messages/msg/mrroc_msgs/msg/{message}.msg").read_text(encoding="utf-8")
    return tuple(name.lower() for name in re.findall(r"^uint8 (\w+)=\d+$", text, re.MULTILINE))


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="mrroc_trace_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def assert_fails(self, path, *parts):
        with self.assertRaises(ValueError) as caught:
            list(mrroc_trace.steps(path))
        for part in (str(path), *parts):
            self.assertIn(part, str(caught.exception))


class Messages(InFolder):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "a.jsonl"

    def write(self, *entries):
        self.path.write_text("".join((entry if isinstance(entry, str) else json.dumps(entry)) + "\n" for entry in entries), encoding="utf-8")

    def step(self, **changes):
        self.write({**ENTRY, "message": {**STEP, **changes}})
        return next(mrroc_trace.steps(self.path))

    def robot(self, **changes):
        return self.step(robots=[{**ARM, **changes}]).robots["arm"]

    def command(self, **changes):
        return self.robot(command=[{**COMMAND, **changes}]).command

    def assert_malformed(self, entry, *parts):
        self.write(ENTRY, entry)
        self.assert_fails(self.path, "a.jsonl: message 2: ", *parts)

    def test_yields_one_step_per_message_of_a_step(self):
        self.write(OTHER, ENTRY, OTHER, ENTRY)
        self.assertEqual(len(list(mrroc_trace.steps(self.path))), 2)

    def test_reads_a_step_of_a_move(self):
        step = self.step()
        self.assertEqual((step.tick, step.process, step.instruction, step.step, step.held), (248, "arm", 4, 12, 0))
        self.assertEqual((step.move, step.wait, step.until), ("ToolVelocity", None, "force above 10 N"))
        self.assertEqual((step.conditions, step.ending, step.skew), ({"force above 10 N": False}, None, None))

    def test_reads_a_step_of_a_wait_without_robots(self):
        near = 'part is "near"'
        step = self.step(is_move=False, name=near, until=[], held=3, robots=[], sensors=[], conditions=[{"name": near, "holds": True}],
                         ending=1, skew=[2])
        self.assertEqual((step.move, step.wait, step.until, step.held), (None, near, None, 3))
        self.assertEqual((step.robots, step.sensors, step.conditions), ({}, {}, {near: True}))
        self.assertEqual((step.ending, step.skew), ("condition", 2))

    def test_reads_a_robot(self):
        arm = self.robot()
        self.assertEqual((arm.tick, arm.macrostep, arm.desired_tick, arm.moving), (248, 240, 250, True))
        self.assertEqual((arm.joints, arm.desired), ([0.5, -1], [0.25, -1]))
        self.assertEqual((arm.pose, arm.desired_pose), ([0.75, 0, -1.5e-05, 4, 1, 2, 3],) * 2)
        self.assertEqual((arm.late, arm.wrench, arm.lost, arm.error), (0, None, 0, None))

    def test_reads_what_a_robot_reports_at_times(self):
        arm = self.robot(moving=False, late_commands=2, wrench=[1, 2, 3, 4, 5, 6], lost=0.25, error_class=2, error="drive fault", command=[])
        self.assertEqual((arm.moving, arm.late, arm.wrench, arm.lost), (False, 2, [1, 2, 3, 4, 5, 6], 0.25))
        self.assertEqual((arm.error, arm.command), ("hardware error: drive fault", None))

    def test_reads_numbers_to_the_last_bit(self):
        joints = self.robot(joints=[0.1, 1, -0.0, None]).joints
        self.assertEqual(repr(joints), "[0.1, 1.0, -0.0, nan]")
        self.path.write_text(self.path.read_text(encoding="utf-8").replace("-0.0", "-0"), encoding="utf-8")  # as mrroc prints it
        again = next(mrroc_trace.steps(self.path)).robots["arm"].joints
        self.assertEqual((math.copysign(1, again[2]), repr(again)), (-1, repr(joints)))

    def test_reads_commands(self):
        hold = self.command(kind=1, target=[])
        self.assertEqual((hold.kind, hold.relative, hold.interpolation, hold.motion_steps, hold.reply_step), ("hold", False, "joints", 10, 8))
        self.assertEqual((hold.start_tick, hold.target, hold.behaviour, hold.wrench), (None, [], None, None))
        pose = self.command(relative=True, interpolation=2, start_tick=260)
        self.assertEqual((pose.kind, pose.relative, pose.interpolation, pose.start_tick, len(pose.target)), ("pose", True, "task", 260, 7))
        self.assertEqual(self.command(kind=5, target=[0.5, -1]).target, [0.5, -1])
        force = self.command(kind=7, target=[0, 0, 0.1, 0, 0, 0, 0, 0, -8, 0, 0, 0], behaviour="ugcccc")
        self.assertEqual((force.target, force.behaviour, force.wrench), ([0, 0, 0.1, 0, 0, 0], "ugcccc", [0, 0, -8, 0, 0, 0]))

    def test_reads_sensors(self):
        eye = {**WRIST, "name": "eye", "values": [], "period": 4, "error_class": 3, "error": "silent"}
        sensors = self.step(sensors=[WRIST, {**eye, "mode": 2}, {**eye, "name": "ear", "mode": 1}]).sensors
        self.assertEqual(sensors["wrist"], mrroc_trace.Sensor(248, [0.5, 2]))
        self.assertEqual(sensors["eye"], mrroc_trace.Sensor(248, [], 4, True, False, "system error: silent"))
        self.assertEqual(sensors["ear"], mrroc_trace.Sensor(248, [], 4, False, True, "system error: silent"))

    def test_words_are_those_of_the_messages(self):
        endings = tuple(word or "none" for word in mrroc_trace.ENDINGS)
        self.assertEqual(constants_of("Command"), mrroc_trace.KINDS + mrroc_trace.INTERPOLATIONS)
        self.assertEqual(constants_of("Step"), endings)
        self.assertEqual(constants_of("SensorReading"), mrroc_trace.MODES)
        self.assertEqual(constants_of("RobotState")[3:], ("no_error", "non_fatal", "hardware", "system"))
        self.assertEqual(len(mrroc_trace.ERRORS), 4)

    def test_rejects_a_line_that_is_cut(self):
        line = json.dumps(ENTRY)
        for size in range(0, len(line), 7):
            with self.subTest(size=size):
                self.assert_malformed(line[:size])
        self.assert_malformed({**ENTRY, "message": {**STEP, "cut": True}}, "the step is cut")

    def test_rejects_missing_fields(self):
        def parts(entry):
            step = entry["message"]
            robot = step["robots"][0]
            return (entry, step, robot, robot["pose"], robot["pose"]["position"], robot["pose"]["orientation"], robot["command"][0],
                    step["sensors"][0], step["conditions"][0])

        reported = copy.deepcopy(ENTRY)
        for part in (parts(reported)[2], parts(reported)[7]):
            part["error_class"] = 1
        for index, part in enumerate(parts(ENTRY)):
            for field in part.keys() - {"time", "topic"} - ({"behaviour"} if part is COMMAND else set()):
                with self.subTest(field=field):
                    entry = copy.deepcopy(reported)
                    del parts(entry)[index][field]
                    self.assert_malformed(entry, f"the field '{field}' is missing")

    def test_rejects_a_field_of_another_type(self):
        for field, value in (("message", 1), ("message", [])):
            self.assert_malformed({**ENTRY, field: value})
        for field, value in (("robots", 1), ("sensors", [1]), ("conditions", None), ("until", 1), ("skew", None), ("ending", "condition")):
            with self.subTest(field=field):
                self.assert_malformed({**ENTRY, "message": {**STEP, field: value}})
        for field, value in (("joints", ["x"]), ("joints", 1), ("pose", []), ("lost", "x"), ("wrench", None), ("command", 1)):
            with self.subTest(field=field):
                self.assert_malformed({**ENTRY, "message": {**STEP, "robots": [{**ARM, field: value}]}})

    def test_rejects_an_unknown_number_of_a_word(self):
        for changes, text in (({"ending": 8}, "ending: 8, expected 0 to 7"),
                              ({"sensors": [{**WRIST, "mode": 3}]}, "mode: 3, expected 0 to 2"),
                              ({"sensors": [{**WRIST, "error_class": -1}]}, "error_class: -1, expected 0 to 3"),
                              ({"robots": [{**ARM, "error_class": 4}]}, "error_class: 4, expected 0 to 3"),
                              ({"robots": [{**ARM, "command": [{**COMMAND, "kind": 9}]}]}, "kind: 9, expected 0 to 8"),
                              ({"robots": [{**ARM, "command": [{**COMMAND, "interpolation": 3}]}]}, "interpolation: 3, expected 0 to 2")):
            with self.subTest(text=text):
                self.assert_malformed({**ENTRY, "message": {**STEP, **changes}}, text)

    def test_rejects_a_target_of_another_size(self):
        for kind, size in (("query", 1), ("hold", 1), ("change", 1), ("pose", 6), ("twist", 7), ("force", 6)):
            with self.subTest(kind=kind):
                command = {**COMMAND, "kind": mrroc_trace.KINDS.index(kind), "target": [0] * size}
                self.assert_malformed({**ENTRY, "message": {**STEP, "robots": [{**ARM, "command": [command]}]}},
                                      f"target of {kind}: {size} numbers, expected {mrroc_trace.TARGETS[kind]}")


class Programs(InFolder):
    """By a program that prints a step, then does what it is asked for."""

    def read_with(self, *commands):
        program = self.folder / "mrroc"
        program.write_text("\n".join(["#!/bin/sh", '[ "$1 $2" = "trace cat" ] || exit 9', f"echo '{json.dumps(ENTRY)}'", *commands, ""]),
                           encoding="utf-8")
        program.chmod(0o755)
        return mock.patch.dict(os.environ, {"MRROC": str(program)})

    def test_reads_until_the_end(self):
        with self.read_with():
            self.assertEqual(len(list(mrroc_trace.steps("a.mcap"))), 1)

    def test_reports_a_failure_after_the_steps_before_it(self):
        with self.read_with("echo 'mrroc: byte 12: a wrong chunk' >&2", "exit 2"):
            steps = mrroc_trace.steps("a.mcap")
            self.assertEqual(next(steps).tick, 248)
            self.assertRaisesRegex(ValueError, "a.mcap: mrroc: byte 12: a wrong chunk", next, steps)
        with self.read_with("kill -9 $$"):
            self.assert_fails("a.mcap", "trace cat: exit code -9")

    def test_reports_a_malformed_message(self):
        with self.read_with("exec yes '{}'"):  # it has no end
            self.assert_fails("a.mcap", "message 2: the field 'type' is missing")

    def test_shows_a_note(self):
        with self.read_with("echo 'mrroc: a.mcap: note: ends early' >&2"), contextlib.redirect_stderr(io.StringIO()) as shown:
            self.assertEqual(len(list(mrroc_trace.steps("a.mcap"))), 1)
        self.assertEqual(shown.getvalue(), "mrroc: a.mcap: note: ends early\n")

    def test_yields_steps_while_the_program_prints(self):
        with self.read_with("exec yes '" + json.dumps(ENTRY) + "'"):
            steps = mrroc_trace.steps("a.mcap")
            self.assertEqual([next(steps).tick for _ in range(1000)], [248] * 1000)
            steps.close()


class Recordings(InFolder):
    def test_reads_a_recording(self):
        recording = self.folder / "press.mcap"
        press = SOURCE / "tasks/press/press.toml"
        subprocess.run([MRROC, "run", press, "--clock", "lockstep", "--quiet", "--black-box=", "--record", recording], check=True, cwd=self.folder)
        with mock.patch.dict(os.environ, {"MRROC": str(MRROC)}):
            steps = list(mrroc_trace.steps(recording))
            self.assert_fails(self.folder / "none.mcap", "No such file")
            (self.folder / "text.mcap").write_text("no recording\n", encoding="utf-8")
            self.assert_fails(self.folder / "text.mcap", "is not an MCAP file")
        checked = subprocess.run([MRROC, "trace", "check", recording], check=True, capture_output=True, text=True).stdout
        self.assertIn(f": {len(steps)} steps of {steps[-1].instruction} instructions of 1 process", checked)
        self.assertEqual([step.tick for step in steps], sorted(step.tick for step in steps))
        for step in steps:
            arm = step.robots["arm"]
            self.assertEqual([len(values) for values in (arm.joints, arm.pose, arm.desired, arm.desired_pose)], [6, 7, 6, 7])
            self.assertAlmostEqual(math.hypot(*arm.pose[3:]), 1)
            self.assertEqual(arm.command is None, step.ending is not None)
        self.assertEqual({sensor for step in steps for sensor in step.sensors}, {"gate", "wrist"})
        self.assertLessEqual({"ToolVelocity", "Hold", "JointLine"}, {step.move for step in steps})
        with open(self.folder / "press.jsonl", "wb") as file:
            subprocess.run([MRROC, "trace", "cat", recording], check=True, stdout=file)
        self.assertEqual(list(mrroc_trace.steps(self.folder / "press.jsonl")), steps)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
