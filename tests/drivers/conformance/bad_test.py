"""A deliberately bad driver fails exactly the checks of the conformance test that it breaks.

Usage: bad_test.py CONFORMANCE_TEST
"""

import os
import re
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop(1)

EXPECTED = {
    "none": set(),
    "allocates": {"real_time"},
    "locks": {"real_time"},
    "sleeps": {"real_time"},
    "late_tick": {"tick"},
    "hides_silence": {"silence"},
    "drives_without_power": {"no_power_no_motion", "off", "origin"},
    "drifts": {"no_jump"},
    "no_origin": {"origin"},
    "opens_anything": {"absent"},
    "off_the_shaft": {"true_positions"},
}


def run(defect, *arguments):
    return subprocess.run(
        [PROGRAM, "bad", "irb6", *arguments], env={**os.environ, "MRROC_TEST_DEFECT": defect}, capture_output=True, text=True, check=False
    )


class BadDriver(unittest.TestCase):
    def test_fails_the_checks_that_it_breaks(self):
        for defect, expected in EXPECTED.items():
            with self.subTest(defect):
                done = run(defect)
                failed = set(re.findall(r"^ *\d+ (\w+) +FAILED", done.stdout, re.M))
                self.assertEqual(failed, expected, done.stdout)
                self.assertEqual(done.returncode, 1 if expected else 0)
                self.assertEqual(len(re.findall(r"^ *\d+ \w+ ", done.stdout, re.M)), 30, done.stdout)

    def test_a_crash_names_driver_and_call(self):
        done = run("crashes", "--only", "10")
        self.assertEqual(done.returncode, -11)
        self.assertRegex(done.stderr, r"driver 'bad' \(.*/bad\.so\) crashed in read \(signal 11\)")

    def test_an_exception_of_the_factory_names_the_driver(self):
        done = run("throws", "--only", "3")
        self.assertEqual(done.returncode, 1)
        self.assertIn("driver 'bad': the factory fails", done.stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
