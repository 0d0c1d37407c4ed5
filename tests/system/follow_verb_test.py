"""Trajectories for a robot that its task yields, from other terminals and from events.

follow_verb_test.py BUILD_FOLDER SOURCE_FOLDER [Follow.TEST ...]
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

BUILD, SOURCE = (pathlib.Path(folder).resolve() for folder in sys.argv[1:3])
MRROC = str(BUILD / "bin/mrroc")
WAITING = str(SOURCE / "tasks/external/waiting.toml")
TIMEOUT = 240
HOME = [0.0, -1.747780928, 0.4768189, -0.299834299, 4.71238898, 1.57079633]  # of robots/irb6/irb6.toml
NEAR = [0.2, -1.7, 0.45, -0.25, 4.6, 1.5]


def mrroc(*words):
    return subprocess.run([MRROC, *map(str, words)], capture_output=True, text=True, timeout=TIMEOUT, check=False)


def point(seconds, positions, **more):
    rows = "".join(f", {name} = {values}" for name, values in more.items())
    return f"  {{time = {seconds}, positions = {positions}{rows}}},\n"


class Follow(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        os.environ["MRROC_RUNTIME_DIR"] = str(self.folder / "sockets")
        (self.folder / "sockets").mkdir(mode=0o700)

    def file(self, *points, name="way.toml", head=""):
        path = self.folder / name
        path.write_text(head + "points = [\n" + "".join(points) + "]\n", encoding="utf-8")
        return path

    def run_waiting(self, *words):
        run = subprocess.Popen([MRROC, "run", WAITING, "--black-box=", "--quiet", *map(str, words)],
                               stdin=subprocess.DEVNULL)
        self.addCleanup(run.kill)
        deadline = time.monotonic() + TIMEOUT
        while "arm" not in json.loads(mrroc("status", "--json").stdout or "{}").get("yields", []):
            self.assertLess(time.monotonic(), deadline, "the arm is not yielded")
            self.assertIsNone(run.poll())
            time.sleep(0.05)
        return run

    def end(self, run):
        self.assertEqual(mrroc("trigger").returncode, 0)
        self.assertEqual(run.wait(TIMEOUT), 0)

    def test_a_live_run_and_its_replay_in_lockstep_are_the_same(self):
        notes, recording = self.folder / "notes.toml", self.folder / "live.mcap"
        run = self.run_waiting("--note-events", notes, "--record", recording)
        there = self.file(point(1.5, NEAR), point(3, HOME))
        self.assertEqual(mrroc("follow", "arm", there).returncode, 0)
        with subprocess.Popen([MRROC, "follow", "arm", there], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as following:
            while "follow" not in notes.read_text().rsplit("[[events]]", 2)[-1] or notes.read_text().count("follow") < 2:
                time.sleep(0.02)
            time.sleep(0.3)
            self.assertEqual(mrroc("cancel", "arm").returncode, 0)
            error = following.communicate(timeout=TIMEOUT)[1].decode()
            self.assertEqual(following.returncode, 1, error)
            self.assertIn("cancelled", error)
        self.assertEqual(mrroc("follow", "arm", self.file(point(2, HOME), name="back.toml")).returncode, 0)
        self.end(run)
        hashes = {mrroc("trace", "hash", recording).stdout}
        self.assertIn("34 rules hold", mrroc("trace", "check", recording).stdout)
        for replay in ("first", "second"):
            again = self.folder / f"{replay}.mcap"
            done = mrroc("run", WAITING, "--clock", "lockstep", "--events", notes, "--record", again, "--black-box=", "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            hashes.add(mrroc("trace", "hash", again).stdout)
        self.assertEqual(len(hashes), 1, hashes)

    def test_what_cannot_be_followed_is_refused_and_nothing_moves(self):
        run = self.run_waiting()
        outside, text = [9.5, *HOME[1:]], self.folder / "text.toml"
        text.write_text("points = [\n  {time = 1, positions = [0, 0]},\n]\n", encoding="utf-8")
        cases = [
            (self.file(point(5, outside), name="outside.toml"), ["point 0", "column", "9.5"]),
            (self.file(point(0.05, NEAR), name="fast.toml"), ["point 0", "velocity", "limit"]),
            (self.file(point(0, NEAR), point(5, HOME), name="elsewhere.toml"), ["point 0 at time 0"]),
            (self.file(point(2, NEAR), point(1, HOME), name="falling.toml"), ["falling.toml:3", "points[1].time"]),
            (text, ["text.toml:2", "positions", "6"]),
            (self.folder / "missing.toml", ["missing.toml"]),
        ]
        before = mrroc("status", "--json").stdout
        for file, words in cases:
            done = mrroc("follow", "arm", file)
            self.assertEqual(done.returncode, 1, (file, done.stdout, done.stderr))
            for word in words:
                self.assertIn(word, done.stderr)
        self.assertEqual(mrroc("follow", "leg", cases[0][0]).returncode, 2)  # wrong, not refused
        self.assertIn("yields", before)
        self.end(run)

    def test_a_task_that_does_not_yield_its_robot_is_left_alone(self):
        with subprocess.Popen([MRROC, "run", SOURCE / "tasks/draw/draw.toml", "--clock", "paced", "--black-box=", "--quiet"],
                              stdin=subprocess.DEVNULL) as run:
            deadline = time.monotonic() + TIMEOUT
            while json.loads(mrroc("status", "--json").stdout or "{}").get("task") != "running":
                self.assertLess(time.monotonic(), deadline)
                time.sleep(0.05)
            done = mrroc("follow", "arm", self.file(point(2, HOME)))
            self.assertEqual(done.returncode, 1)
            self.assertIn("no task yields arm", done.stderr)
            self.assertEqual(mrroc("stop").returncode, 0)
            run.wait(TIMEOUT)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
