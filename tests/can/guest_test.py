#!/usr/bin/env python3
"""Tests with_can in a guest: frames between processes, statuses, files, environment, time limit, no remaining processes."""

import os
import pathlib
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
FRAME = struct.Struct("=IB3x8s")
ECHO = 0x100  # added to the identifier


def can_socket(interface):
    opened = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    opened.bind((interface,))
    return opened


def echo():
    """Two processes: the child sends back the frames of can1."""
    ready, child = os.pipe(), os.fork()
    bus = can_socket("can1")
    if child == 0:
        os.write(ready[1], b"1")
        while True:
            identifier, length, data = FRAME.unpack(bus.recv(FRAME.size))
            bus.send(FRAME.pack(identifier + ECHO, length, data))
    os.read(ready[0], 1)
    bus.settimeout(5)
    for number in range(100):
        bus.send(FRAME.pack(number, 4, struct.pack("<I", number)))
        identifier, length, data = FRAME.unpack(bus.recv(FRAME.size))
        if (identifier, length, data[:4]) != (number + ECHO, 4, struct.pack("<I", number)):
            return f"frame {number} came back as {identifier:x} {data}"
    print("100 frames came back")
    os.kill(child, 9)
    return 0


class GuestTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="guest_test_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "temporary").mkdir()

    def tearDown(self):
        self.assertEqual(list((self.folder / "temporary").iterdir()), [])

    def begin_in_guest(self, *arguments):
        environment = os.environ | {"TMPDIR": str(self.folder / "temporary")}
        command = [HERE / "with_can", "--guest", *arguments]
        return subprocess.Popen(
            command, cwd=self.folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def run_in_guest(self, *arguments):
        process = self.begin_in_guest(*arguments)
        out, err = process.communicate()
        return subprocess.CompletedProcess(process.args, process.returncode, out, err)

    def test_two_processes_exchange_frames(self):
        result = self.run_in_guest("--", sys.executable, __file__, "echo")
        self.assertEqual((result.returncode, result.stdout), (0, "100 frames came back\n"), result.stderr)

    def test_tools(self):
        listen_and_send = "candump -n 1 -T 5000 can0 & sleep 0.3; cansend can0 123#1122; wait"
        result = self.run_in_guest("--interfaces", "1", "--", "sh", "-c", listen_and_send)
        self.assertEqual(result.stdout.split(), ["can0", "123", "[2]", "11", "22"], result.stderr)

    def test_files_and_environment(self):
        kept = self.folder / "kept"
        kept.mkdir()
        (self.folder / "read").write_text("of the host\n", encoding="utf-8")
        command = 'pwd; cat read; echo "$WORD"; echo changed >read; cat read; echo it >kept/file; echo told >&2; exit 7'
        result = self.run_in_guest("--writable", str(kept), "--env", "WORD=two words", "--", "sh", "-c", command)
        self.assertEqual(result.returncode, 7)
        self.assertEqual(result.stdout, f"{self.folder}\nof the host\ntwo words\nchanged\n")
        self.assertEqual(result.stderr, "told\n")
        self.assertEqual((kept / "file").read_text(encoding="utf-8"), "it\n")
        self.assertEqual((self.folder / "read").read_text(encoding="utf-8"), "of the host\n")

    def test_time_limit(self):
        result = self.run_in_guest("--timeout", "20", "--", "sh", "-c", "echo begun; sleep 1000")
        self.assertEqual((result.returncode, result.stdout), (124, "begun\n"))
        self.assertIn("with_can: killed after 20 s: sh -c", result.stderr)

    def test_dead_guest(self):
        process = self.begin_in_guest("--", "sh", "-c", "echo begun; sleep 1000")
        self.assertEqual(process.stdout.readline(), "begun\n")
        own = f"uml_dir={self.folder}/".encode()
        for command_line in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = command_line.read_bytes().split(b"\0")
                if words[0] == b"linux.uml" and any(word.startswith(own) for word in words):
                    os.kill(int(command_line.parent.name), signal.SIGKILL)
            except (FileNotFoundError, ProcessLookupError):
                pass
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 125, errors)
        self.assertIn("with_can: the guest died", errors)


if __name__ == "__main__":
    sys.exit(echo() if sys.argv[1:] == ["echo"] else unittest.main(verbosity=2))
