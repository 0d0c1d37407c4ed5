"""Whole tasks at the operator's speed, in lockstep: they succeed, take longer, and their recordings obey the laws.

speed_test.py BUILD_FOLDER SOURCE_FOLDER
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, SOURCE = (pathlib.Path(folder).resolve() for folder in sys.argv[1:3])
MRROC = str(BUILD / "bin/mrroc")
os.environ["MRROC"] = MRROC
sys.path.insert(0, str(SOURCE / "scripts"))
import mrroc_trace

TIMEOUT = 240


def output_of(*arguments):
    done = subprocess.run([MRROC, *arguments], capture_output=True, text=True, timeout=TIMEOUT, check=False,
                          stdin=subprocess.DEVNULL)
    assert done.returncode == 0, (arguments, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


class Speed(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        os.environ["MRROC_RUNTIME_DIR"] = f"{self.folder}/mrroc"

    def tearDown(self):
        shutil.rmtree(self.folder)

    def run_with(self, task, *speeds):
        """Runs with (tick, percent) pairs; returns the last tick and the hash."""
        events = self.folder / "events.toml"
        events.write_text("".join(f'[[events]]\ntick = {tick}\ncommand = "speed"\nvalue = {percent}\n\n'
                                  for tick, percent in speeds), encoding="utf-8")
        recording = self.folder / "run.mcap"
        output_of("run", str(SOURCE / f"tasks/{task}/{task}.toml"), "--clock", "lockstep", "--events", str(events),
                  "--record", str(recording), "--quiet", "--black-box=")
        output_of("trace", "check", str(recording))
        return max(step.tick for step in mrroc_trace.steps(recording)), output_of("trace", "hash", str(recording))

    def check(self, task):
        full, plain = self.run_with(task)
        self.assertEqual(self.run_with(task, (0, 100)), (full, plain), "100 % changes nothing")
        slow, changed = self.run_with(task, (500, 30), (2500, 100))
        self.assertNotEqual(changed, plain)
        # 2000 ticks, of which the motions cover 600; the ramps take at most 1 s each
        self.assertGreater(slow - full, 400)
        self.assertLess(slow - full, 1400 + 500)
        self.assertEqual(self.run_with(task, (500, 30), (2500, 100)), (slow, changed))
        half, _ = self.run_with(task, (0, 50))
        self.assertGreater(half, 1.3 * full)
        self.assertLess(half, 2.05 * full)

    def test_one_robot(self):
        self.check("draw")

    def test_two_robots_with_one_object(self):
        self.check("cooperative_transfer")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
