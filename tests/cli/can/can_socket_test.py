#!/usr/bin/env python3
"""`mrroc can` on the interface can0, whose drives are those of tests/can/peer_drive.py. Usage: can_socket_test.py MRROC"""

import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
EDS = str(ROOT / "src/canopen/cia402.eds")
MRROC = sys.argv.pop(1)


def run(*arguments):
    return subprocess.run([MRROC, "can", *arguments], capture_output=True, text=True, check=False)


class CanTest(unittest.TestCase):
    def start_drives(self, *nodes):
        command = [sys.executable, ROOT / "tests/can/peer_drive.py", "--bus", "can0", "--eds", EDS, *nodes]
        drives = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.addCleanup(drives.communicate)
        self.addCleanup(drives.kill)
        self.assertEqual(drives.stdout.readline(), "ready\n")

    def test_scan(self):
        self.start_drives("3", "100")
        found = run("scan", "can0", "--patience", "2")
        self.assertEqual((found.returncode, found.stderr), (0, ""))
        lines = found.stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["node", "3", "100"])
        for line in lines[1:]:
            self.assertIn('402 (drive)  "CiA 402 servo drive"', line)

    def test_no_node(self):
        found = run("scan", "can1", "--patience", "0.1")
        self.assertEqual(found.returncode, 1)
        self.assertTrue(found.stderr.startswith("can1: no node has answered within 0.1 s\nLook at\n"), found.stderr)

    def test_bad_interface(self):
        found = run("scan", "can9")
        self.assertEqual(found.returncode, 2)
        self.assertIn("mrroc: CAN interface 'can9': is not there", found.stderr)

    def test_monitor(self):
        self.start_drives("3")
        command = [MRROC, "can", "monitor", "can0", "--robot", "irb6", "--count", "400"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as monitor:
            while monitor.poll() is None:  # one scan sends fewer frames
                run("scan", "can0", "--patience", "0.3")
            output = monitor.stdout.read()
        self.assertEqual((monitor.returncode, len(output.splitlines())), (0, 400))
        for words in ("upper_arm SDO read 1000h:0 (Device type)", "node 100 SDO read 1000h:0 (Device type)",
                      "upper_arm SDO value 1000h:0 (Device type) = 92 01 02 00",
                      "upper_arm SDO value 1008h:0 (Manufacturer device name), 19 bytes"):
            self.assertIn("  " + words + "\n", output)


if __name__ == "__main__":
    unittest.main(verbosity=2)
