"""mrroc_trace reads every field of docs/reference/trace.md and reports a line that is malformed with its file, number and fault."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import mrroc_trace

HEADER = "# mrroc trace 2 clock=lockstep\n"
HEAD = 'tick=248 process=arm instruction=4 move="ToolVelocity" until="force above 10 N or travelled 0.15 m" step=12'
POSE = "0.75,0,-1.5e-05,0,1,0,0"
ARM = f" robot=arm tick=248 macrostep=240 joints=0.5,-1 pose={POSE} desired_tick=250 desired=0.5,-1 desired_pose=0.75,0,0.1,1,0,0,0"
COMMAND = f" command=pose,N10,v8:{POSE}"
SENSOR = " sensor=wrist tick=248 values=0.5,2"
CONDITIONS = ' condition="force above 10 N":0 condition="travelled 0.15 m":1'
LINE = HEAD + ARM + " moving" + COMMAND + SENSOR + CONDITIONS + "\n"


class TraceReader(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="mrroc_trace_")
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "a.trace"

    def steps(self, text):
        self.path.write_text(text, encoding="utf-8")
        return list(mrroc_trace.steps(self.path))

    def step(self, line):
        return self.steps(line + "\n")[0]

    def command(self, text):
        return self.step(f"{HEAD}{ARM} command={text}").robots["arm"].command

    def assert_malformed(self, line, *parts):
        with self.assertRaises(ValueError) as caught:
            self.steps(HEADER + LINE + line)
        for part in (f"{self.path}:3: ", *parts):
            self.assertIn(part, str(caught.exception))

    def test_yields_one_step_per_line_and_skips_comments(self):
        self.assertEqual(len(self.steps(HEADER + LINE + LINE + "# process=arm lines=2 dropped=0 cut=0\n")), 2)

    def test_reads_a_step_of_a_move(self):
        step = self.step(LINE.rstrip())
        self.assertEqual((step.tick, step.process, step.instruction, step.step, step.held), (248, "arm", 4, 12, 0))
        self.assertEqual((step.move, step.wait, step.until), ("ToolVelocity", None, "force above 10 N or travelled 0.15 m"))
        self.assertEqual(step.conditions, {"force above 10 N": False, "travelled 0.15 m": True})
        self.assertEqual((step.ending, step.skew), (None, None))

    def test_reads_a_step_of_a_wait_without_robots(self):
        step = self.step('tick=0 process=mp instruction=1 wait="part is "near"" step=0 held=3 condition="part is "near"":1 end=condition skew=2')
        self.assertEqual((step.move, step.wait, step.until, step.held), (None, 'part is "near"', None, 3))
        self.assertEqual((step.robots, step.sensors, step.conditions), ({}, {}, {'part is "near"': True}))
        self.assertEqual((step.ending, step.skew), ("condition", 2))

    def test_reads_a_robot(self):
        arm = self.step(LINE.rstrip()).robots["arm"]
        self.assertEqual((arm.tick, arm.macrostep, arm.desired_tick, arm.moving), (248, 240, 250, True))
        self.assertEqual((arm.joints, arm.desired), ([0.5, -1], [0.5, -1]))
        self.assertEqual(arm.pose, [0.75, 0, -1.5e-05, 0, 1, 0, 0])
        self.assertEqual(arm.desired_pose, [0.75, 0, 0.1, 1, 0, 0, 0])
        self.assertEqual((arm.late, arm.wrench, arm.lost, arm.error), (0, None, 0, None))
        self.assertEqual(arm.command.target, arm.pose)

    def test_reads_what_a_robot_reports_at_times(self):
        report = ' late=2 wrench=1,2,3,4,5,6 lost=0.25 error="hardware: drive fault"'
        robots = self.step(HEAD + ARM + report + ARM.replace("=arm", "=belt") + " end=hardware_error").robots
        self.assertEqual(list(robots), ["arm", "belt"])
        arm = robots["arm"]
        self.assertEqual((arm.moving, arm.late, arm.wrench, arm.lost), (False, 2, [1, 2, 3, 4, 5, 6], 0.25))
        self.assertEqual((arm.error, arm.command), ("hardware: drive fault", None))

    def test_reads_commands(self):
        hold = self.command("hold,N10,v8")
        self.assertEqual((hold.kind, hold.relative, hold.interpolation, hold.motion_steps, hold.reply_step), ("hold", False, "joints", 10, 8))
        self.assertEqual((hold.start_tick, hold.target, hold.behaviour, hold.wrench), (None, [], None, None))
        pose = self.command(f"pose,relative,task,N20,v18,start260:{POSE}")
        self.assertEqual((pose.relative, pose.interpolation, pose.start_tick, len(pose.target)), (True, "task", 260, 7))
        self.assertEqual(self.command("joint_velocity,N10,v8:0.5,-1").target, [0.5, -1])
        force = self.command("force,N10,v8:0,0,0.1,0,0,0,ugcccc,0,0,-8,0,0,0")
        self.assertEqual((force.target, force.behaviour, force.wrench), ([0, 0, 0.1, 0, 0, 0], "ugcccc", [0, 0, -8, 0, 0, 0]))

    def test_reads_sensors(self):
        sensors = self.step(f'{HEAD}{SENSOR} sensor=eye tick=240 values= period=4 published polled error="system: silent"').sensors
        self.assertEqual(sensors["wrist"], mrroc_trace.Sensor(248, [0.5, 2]))
        self.assertEqual(sensors["eye"], mrroc_trace.Sensor(240, [], 4, True, True, "system: silent"))

    def test_rejects_a_cut_line_at_every_place(self):
        for size in range(1, len(LINE)):
            with self.subTest(size=size):
                self.assert_malformed(LINE[:size], "this line is cut")
        self.assert_malformed(HEAD + " " * 16384 + "\n", "this line is cut")

    def test_rejects_missing_fields(self):
        self.assert_malformed("\n", "expected the fields tick, process, instruction")
        self.assert_malformed(LINE.replace("tick=248 process", "process"), "expected the fields tick, process, instruction")
        self.assert_malformed(LINE.replace(f" pose={POSE}", ""), "' robot=arm", "expected the fields robot, tick, macrostep, joints, pose")
        self.assert_malformed(LINE.replace(" values=0.5,2", ""), "' sensor=wrist", "expected the fields sensor, tick, values")

    def test_rejects_an_unknown_field(self):
        for place in (" robot=", " command=", " sensor=", " condition=", "\n"):
            with self.subTest(place=place):
                line = LINE.replace(place, " colour=red" + place, 1)
                self.assert_malformed(line, "' colour=red", "expected a field of the trace or the end of the line")

    def test_rejects_a_wrong_number(self):
        self.assert_malformed(LINE.replace("step=12", "step=-1"), "step: '-1', expected a whole number")
        self.assert_malformed(LINE.replace("macrostep=240", "macrostep=24o"), "macrostep: '24o', expected a whole number")
        self.assert_malformed(LINE.replace("joints=0.5,-1", "joints=0.5.1,-1"), "joints: '0.5.1,-1', expected numbers separated by commas")
        self.assert_malformed(LINE.replace("values=0.5,2", "values=0.5,"), "values: '0.5,', expected numbers separated by commas")
        self.assert_malformed(LINE.replace(f" pose={POSE}", " pose=1,2,3"), "pose: '1,2,3', expected 7 numbers")

    def test_rejects_a_wrong_value(self):
        self.assert_malformed(LINE.replace('m":1', 'm":2'), "expected the fields condition, value")
        self.assert_malformed(LINE.rstrip() + " end=early\n", "ending: 'early', expected one of condition, generator")

    def test_rejects_a_wrong_command(self):
        for command in ("leap,N10,v8", "hold,N10", "hold,N10,v8:1", "joint,N10,v8", "joint,N10,v8:1,x", "pose,N10,v8:1,2", "twist,N10,v8:1",
                        "force,N10,v8:1,2,3,4,5,6", "joint,N10,v8:1,uuuuuu,1,2,3,4,5,6"):
            with self.subTest(command=command):
                self.assert_malformed(f"{HEAD}{ARM} command={command}\n", "command: ")


if __name__ == "__main__":
    unittest.main()
