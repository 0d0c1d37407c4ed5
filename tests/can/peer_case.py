"""A master of python-canopen for the tests of peer_drive.py, with two drives on its bus."""

import pathlib
import struct
import subprocess
import sys
import time
import unittest

import canopen

from unix_bus import open_bus

HERE = pathlib.Path(__file__).resolve().parent
EDS = str(HERE.parent.parent / "src/canopen/cia402.eds")
NODE, OTHER, MASTER = 3, 4, 1
CYCLE = 0.01
ANSWER = 5  # s for an answer on a busy machine
DISABLED, READY, SWITCHED_ON, ENABLED, QUICK_STOP, FAULT = 0x40, 0x21, 0x23, 0x27, 0x07, 0x08
HOMING, POSITION, VELOCITY, TORQUE = 6, 8, 9, 10


class PeerCase(unittest.TestCase):
    bus_name = None
    node_class = canopen.RemoteNode
    in_cycles = False  # the motors turn by CYCLE at each SYNC, else in real time

    def setUp(self):
        self.network = canopen.Network(open_bus(self.bus_name))
        self.network.connect()
        nodes = [self.node_class(number, canopen.import_od(EDS, number)) for number in (NODE, OTHER)]
        self.node, self.other = (self.network.add_node(node) for node in nodes)
        self.node.sdo.RESPONSE_TIMEOUT = self.other.sdo.RESPONSE_TIMEOUT = ANSWER
        self.reported = []  # every heartbeat's state; 0 is the boot-up message
        self.node.nmt.add_heartbeat_callback(self.reported.append)
        command = [sys.executable, HERE / "peer_drive.py", "--bus", self.bus_name, "--eds", EDS, str(NODE), str(OTHER)]
        command += ["--cycle", str(CYCLE)] if self.in_cycles else []
        self.peer = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.assertEqual(self.peer.stdout.readline(), "ready\n")
        self.wait_for_bootup()

    def tearDown(self):
        self.network.disconnect()
        self.peer.kill()
        self.peer.communicate()

    def tell(self, line):
        self.peer.stdin.write(line + "\n")
        self.peer.stdin.flush()
        self.assertEqual(self.peer.stdout.readline(), f"done {line}\n")

    def configure(self):
        """Controlword, mode and target on each SYNC; statusword, position and velocity on each second."""
        receive, transmit = self.node.rpdo, self.node.tpdo
        for pdo, variables, kind in ((receive[1], (0x6040, 0x6060, 0x607A), 1), (receive[2], (0x60FF, 0x6071), 1),
                                     (transmit[1], (0x6041, 0x6061, 0x6064), 2), (transmit[2], (0x606C, 0x6077), 2)):
            pdo.read()
            pdo.clear()
            for index in variables:
                pdo.add_variable(index)
            pdo.trans_type, pdo.enabled = kind, True
            pdo.save()
        self.output = {0x6040: 0, 0x6060: 0, 0x607A: 0, 0x60FF: 0, 0x6071: 0}
        self.node.nmt.state = "OPERATIONAL"

    def cycle(self, count=1):
        for _ in range(count):
            values = self.output
            self.network.send_message(0x200 + NODE, struct.pack("<Hbi", values[0x6040], values[0x6060], values[0x607A]))
            self.network.send_message(0x300 + NODE, struct.pack("<ih", values[0x60FF], values[0x6071]))
            self.network.sync.transmit()
            time.sleep(CYCLE)
        self.node.sdo.upload(0x1000, 0)  # answered behind the frames of the last SYNC

    def state(self):
        word = self.node.tpdo[1][0x6041].raw
        return word & (0x6F if word & 0x20 else 0x4F)

    def drive(self, word, state):
        self.output[0x6040] = word
        for _ in range(200):  # on a busy machine the answers are late
            self.cycle()
            if self.state() == state:
                return
        self.fail(f"controlword {word:#x}: statusword {self.node.tpdo[1][0x6041].raw:#x}, expected {state:#x}")

    def enable(self, mode):
        self.output[0x6060] = mode
        self.output[0x607A] = self.node.sdo[0x6064].raw
        for word, state in ((0x80, DISABLED), (0x06, READY), (0x07, SWITCHED_ON), (0x0F, ENABLED)):
            self.drive(word, state)
        self.cycle(2)
        self.assertEqual(self.node.tpdo[1][0x6061].raw, mode)

    def emergency(self, code):
        """The last message of the node with that error code."""
        found = lambda: [entry for entry in self.node.emcy.log if entry.code == code]
        self.wait(found, f"no emergency {code:#x}")
        return found()[-1]

    def wait_for_bootup(self):
        self.wait(lambda: 0 in self.reported, "no boot-up message")
        self.reported.clear()

    def wait(self, condition, problem):
        deadline = time.monotonic() + ANSWER
        while not condition():
            self.assertLess(time.monotonic(), deadline, problem)
            time.sleep(CYCLE)
