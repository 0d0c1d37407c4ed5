"""A deliberately bad driver, or clock of a driver, fails exactly the checks of the conformance test that it breaks.

Usage: bad_test.py TEST_OF_STREAM TEST_OF_UR PARAMETERS_OF_UR SANITIZERS=NAMES

In a build with sanitizers, which allocate and lock for themselves, neither is counted.
"""

import os
import re
import subprocess
import sys
import unittest

PROGRAM, UR_PROGRAM, UR_PARAMETERS, SANITIZERS = (sys.argv.pop(1) for _ in range(4))
SANITIZERS = SANITIZERS.partition("=")[2]

EXPECTED = {
    "none": set(),
    "allocates": set() if SANITIZERS else {"real_time"},
    "locks": set() if SANITIZERS else {"real_time"},
    "sleeps": {"real_time"},
    "late_tick": {"tick"},
    "hides_silence": {"silence"},
    "drives_without_power": {"no_power_no_motion", "off", "origin"},
    "drifts": {"no_jump"},
    "no_origin": {"origin"},
    "opens_anything": {"absent"},
    "off_the_shaft": {"true_positions"},
}

OF_THE_CLOCK = {
    "none": set(),
    "repeats": {"beats"},
    "gives_up_early": {"beats_end"},
    "stays_silent": {"beats_end"},
    "does_not_count": {"beats_counted"},
}
CHECKS = 33
CLOCK_CHECKS = (31, 32, 33)


def run(defect, *arguments, program=(PROGRAM, "bad", "irb6")):
    environment = {**os.environ, "MRROC_TEST_DEFECT": defect}
    for options in ("ASAN_OPTIONS", "TSAN_OPTIONS"):  # a crash is the driver's
        environment[options] = environment.get(options, "") + ":handle_segv=0"
    return subprocess.run([*program, *arguments], env=environment, capture_output=True, text=True, check=False)


def failed(output):
    return set(re.findall(r"^ *\d+ (\w+) +FAILED", output, re.M))


class BadDriver(unittest.TestCase):
    def test_fails_the_checks_that_it_breaks(self):
        for defect, expected in EXPECTED.items():
            with self.subTest(defect):
                done = run(defect)
                self.assertEqual(failed(done.stdout), expected, done.stdout)
                self.assertEqual(done.returncode, 1 if expected else 0)
                self.assertEqual(len(re.findall(r"^ *\d+ \w+ ", done.stdout, re.M)), CHECKS, done.stdout)

    def test_fails_the_checks_of_the_clock_that_it_breaks(self):
        for defect, expected in OF_THE_CLOCK.items():
            with self.subTest(defect):
                done = [run(defect, "--only", str(number), program=(UR_PROGRAM, "bad_clock", "irb6", UR_PARAMETERS)) for number in CLOCK_CHECKS]
                output = "".join(each.stdout for each in done)
                self.assertEqual(failed(output), expected, output)
                self.assertEqual(output.count(" passed  "), len(CLOCK_CHECKS) - len(expected), output)

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
