#!/usr/bin/env python3
"""Tests peer_drive.py against CiA 301 and CiA 402 with a master of python-canopen.

Usage: peer_test.py [BUS]; without a bus it makes its own hub.
"""

import sys
import tempfile
import time
import unittest

import canopen
from canopen.profiles.p402 import BaseNode402

from peer_case import (ANSWER, CYCLE, DISABLED, ENABLED, FAULT, HOMING, MASTER, NODE, OTHER, POSITION, QUICK_STOP, READY,
                       SWITCHED_ON, TORQUE, VELOCITY, PeerCase)
from unix_bus import Hub


class DriveTest(PeerCase):
    in_cycles = True

    def test_objects(self):
        self.assertEqual(self.node.sdo[0x1000].raw, 0x00020192)
        self.assertEqual(self.node.sdo[0x1008].raw, "CiA 402 servo drive")
        self.assertEqual(self.node.sdo["Supported drive modes"].raw, 0x3A0)
        self.assertEqual(self.node.sdo[0x1400][1].raw, 0x200 + NODE)
        self.assertEqual(self.other.sdo[0x1400][1].raw, 0x200 + OTHER)
        refused = ((0x2345, 0, b"\0", 0x06020000), (0x1018, 9, b"\0", 0x06090011), (0x6041, 0, b"\0\0", 0x06010002),
                   (0x6040, 0, b"\0", 0x06070010), (0x6060, 0, b"\x03", 0x06090030), (0x1600, 1, bytes(4), 0x08000022))
        for index, subindex, data, code in refused:
            with self.subTest(index=hex(index)), self.assertRaises(canopen.SdoAbortedError) as caught:
                self.node.sdo.download(index, subindex, data)
            self.assertEqual(caught.exception.code, code)

    def test_cyclic_modes(self):
        self.configure()
        self.enable(POSITION)
        for target in range(0, 5001, 100):
            self.output[0x607A] = target
            self.cycle()
        self.cycle(10)
        self.assertEqual(self.node.tpdo[1][0x6064].raw, 5000)
        self.assertEqual(self.node.sdo[0x60F4].raw, 0)
        self.output |= {0x6060: VELOCITY, 0x60FF: 20000}
        self.cycle(30)
        self.assertAlmostEqual(self.node.tpdo[2][0x606C].raw, 20000, delta=200)
        self.assertGreater(self.node.tpdo[1][0x6064].raw, 6000)
        self.tell(f"node {NODE} limit positive on")
        self.cycle(4)
        self.assertEqual(self.node.tpdo[2][0x606C].raw, 0)
        self.assertTrue(self.node.tpdo[1][0x6041].raw & 0x0800)
        self.assertEqual(self.node.sdo[0x60FD].raw, 2)
        self.output |= {0x6060: TORQUE, 0x6071: -50}
        self.cycle(100)
        self.assertEqual(self.node.tpdo[2][0x6077].raw, -50)
        self.assertAlmostEqual(self.node.tpdo[2][0x606C].raw, -50000, delta=1000)

    def test_states(self):
        self.configure()
        walk = ((0x0F, DISABLED), (0x07, DISABLED), (0x06, READY), (0x0F, ENABLED), (0x07, SWITCHED_ON), (0x06, READY),
                (0x07, SWITCHED_ON), (0x00, DISABLED), (0x06, READY), (0x02, DISABLED), (0x06, READY), (0x0F, ENABLED),
                (0x06, READY), (0x0F, ENABLED), (0x00, DISABLED))
        for word, state in walk:
            self.drive(word, state)
            self.cycle(2)
            self.assertEqual(self.state(), state)

    def test_quick_stop(self):
        self.configure()
        self.node.sdo[0x605A].raw = 6
        self.node.sdo[0x6085].raw = 100000
        self.enable(VELOCITY)
        self.output[0x60FF] = 20000
        self.cycle(20)
        self.drive(0x02, QUICK_STOP)
        self.assertGreater(self.node.tpdo[2][0x606C].raw, 0)
        self.cycle(30)
        self.assertEqual(self.node.tpdo[2][0x606C].raw, 0)
        self.assertEqual(self.state(), QUICK_STOP)
        self.drive(0x0F, ENABLED)
        self.output[0x6040] = 0x02
        self.node.sdo[0x605A].raw = 2
        self.drive(0x02, DISABLED)

    def test_homing(self):
        self.configure()
        self.enable(VELOCITY)
        self.output[0x60FF] = 10000
        self.cycle(20)
        self.node.sdo[0x607C].raw = 250
        self.node.sdo[0x6098].raw = 23
        self.output[0x6060] = HOMING
        self.cycle(4)
        self.assertFalse(self.node.tpdo[1][0x6041].raw & 0x1000)
        self.output[0x6040] = 0x1F
        self.cycle(6)
        self.assertFalse(self.node.tpdo[1][0x6041].raw & 0x1400)
        self.cycle(60)
        self.assertEqual(self.node.tpdo[1][0x6041].raw & 0x3400, 0x1400)
        self.assertEqual(self.node.tpdo[1][0x6064].raw, -250)

    def test_faults(self):
        self.configure()
        self.enable(POSITION)
        self.tell("emcy 0x7305")
        self.assertEqual(self.emergency(0x7305).register, 0x21)
        self.cycle(4)
        self.assertEqual(self.state(), FAULT)
        self.assertEqual(self.node.sdo[0x603F].raw, 0x7305)
        self.assertEqual(self.node.sdo[0x1001].raw, 0x21)
        self.assertEqual(self.node.sdo[0x1003][1].raw, 0x7305)
        self.drive(0x00, FAULT)
        self.drive(0x80, DISABLED)
        self.assertEqual(self.emergency(0).register, 0)
        self.assertEqual(self.node.sdo[0x1001].raw, 0)
        self.node.sdo[0x6065].raw, self.node.sdo[0x6066].raw = 50, 20
        self.enable(POSITION)
        self.tell("jam on")
        self.output[0x607A] += 1000
        self.cycle(10)
        self.assertEqual(self.state(), FAULT)
        self.assertEqual(self.node.sdo[0x603F].raw, 0x8611)

    def test_heartbeats(self):
        self.node.sdo[0x1017].raw = 20
        self.assertEqual(self.node.nmt.wait_for_heartbeat(1), "PRE-OPERATIONAL")
        self.configure()
        self.enable(POSITION)
        self.node.sdo[0x1016][1].raw = MASTER << 16 | 300
        for _ in range(10):
            self.network.send_message(0x700 + MASTER, [5])
            time.sleep(0.03)
        self.assertEqual(self.node.emcy.log, [])
        self.assertEqual(self.emergency(0x8130).register, 0x11)
        self.assertEqual(self.node.nmt.wait_for_heartbeat(1), "PRE-OPERATIONAL")
        time.sleep(0.1)
        self.assertEqual(self.node.sdo[0x6041].raw & 0x4F, FAULT)
        self.tell(f"node {NODE} silence")
        time.sleep(0.05)
        with self.assertRaises(canopen.nmt.NmtError):
            self.node.nmt.wait_for_heartbeat(0.2)
        self.tell(f"node {NODE} speak")
        self.assertEqual(self.node.nmt.wait_for_heartbeat(1), "PRE-OPERATIONAL")
        self.peer.stdin.write("die\n")
        self.peer.stdin.flush()
        self.assertEqual(self.peer.wait(2), 1)
        with self.assertRaises(canopen.nmt.NmtError):
            self.node.nmt.wait_for_heartbeat(0.2)

    def test_network_management(self):
        self.configure()
        self.enable(POSITION)
        self.node.nmt.state = "STOPPED"
        self.node.sdo.RESPONSE_TIMEOUT = 0.2
        with self.assertRaises(canopen.SdoCommunicationError):
            self.node.sdo.upload(0x1000, 0)
        self.node.sdo.RESPONSE_TIMEOUT = ANSWER
        self.reported.clear()
        self.network.nmt.send_command(129)
        self.wait_for_bootup()
        self.assertEqual(self.node.sdo[0x1A00][0].raw, 2)
        self.assertEqual(self.node.sdo[0x6041].raw & 0x6F, DISABLED)


class ProfileTest(PeerCase):
    """python-canopen's own CiA 402 master, over event-driven frames."""

    node_class = BaseNode402

    def test_operation_enabled(self):
        self.node.nmt.state = "PRE-OPERATIONAL"
        self.node.setup_402_state_machine()
        for pdo in (self.node.rpdo[1], self.node.tpdo[1]):
            pdo.trans_type = 255
            pdo.save()
        self.node.nmt.state = "OPERATIONAL"
        self.network.sync.start(CYCLE)
        self.node.state = "OPERATION ENABLED"
        self.assertEqual(self.node.state, "OPERATION ENABLED")
        self.network.sync.stop()


def main():
    with tempfile.TemporaryDirectory(prefix="peer_test_") as folder:
        if len(sys.argv) > 1:
            PeerCase.bus_name = sys.argv[1]
        else:
            PeerCase.bus_name = f"unix:{folder}/hub"
            Hub(f"{folder}/hub")
        return not unittest.main(argv=sys.argv[:1], verbosity=2, exit=False).result.wasSuccessful()


if __name__ == "__main__":
    sys.exit(main())
