"""Tests that noisy_host takes processor time away, returns the command's exit code and leaves no process behind."""

import pathlib
import subprocess
import sys
import unittest

TOOL = str(pathlib.Path(__file__).with_name("noisy_host"))
# uses a second of processor time, and prints how often it was interrupted
SPIN = "import resource, time\nwhile time.process_time() < 1: pass\nprint(resource.getrusage(resource.RUSAGE_SELF).ru_nivcsw)"


def run(*words):
    return subprocess.run([TOOL, *words], capture_output=True, text=True)


class NoisyHost(unittest.TestCase):
    def test_takes_the_processors(self):
        done = run("--fraction", "0.3", "--longest", "0.01", "--", sys.executable, "-c", SPIN)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(int(done.stdout), 20)

    def test_returns_the_exit_code_and_leaves_no_process(self):
        self.assertEqual(run("--", "sh", "-c", "exit 3").returncode, 3)
        self.assertEqual(run("--", "sh", "-c", "kill -9 $$").returncode, 137)
        left = subprocess.run(["pgrep", "-f", f"{TOOL} --"], capture_output=True, text=True)
        self.assertEqual(left.stdout, "")

    def test_reports_invalid_arguments(self):
        done = run("--fraction", "1.5", "--", "true")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--fraction 1.5", done.stderr)


if __name__ == "__main__":
    unittest.main()
