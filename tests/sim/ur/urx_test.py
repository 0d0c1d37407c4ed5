#!/usr/bin/env python3
"""Tests the simulated UR controller with the third-party client urx, which speaks other protocols than RTDE.

urx reads the robot's state from the secondary interface (30002) and the real-time interface (30003), and moves the robot by lines of
URScript. Its ports are fixed, so each controller listens on a loopback address of its own. It was written for a CB3 before PolyScope 3.5,
so the controller is one of PolyScope 3.4.

Usage: urx_test.py UR_CONTROLLER
"""

import math
import socket
import sys
import time
import unittest

import urx.urrobot

from controller import Controller

TIMEOUT = 60  # s; long, so that a busy machine does not cause a failure
HOME = [0, -1.5, 1.5, -1.5, -1.5, 0]
LOAD = [3.0, -2.0, 25.0, 0.1, 0.2, -0.3]  # N, N m, on the flange and in its frame
PROGRAM = ""


class LongTimeoutSockets:
    """Replaces the half second after which urx gives up."""

    @staticmethod
    def create_connection(address, timeout=None):
        return socket.create_connection(address, TIMEOUT)


urx.ursecmon.socket = LongTimeoutSockets
urx.ursecmon.SecondaryMonitor.wait.__defaults__ = (TIMEOUT,)


class UrxTest(unittest.TestCase):
    def robot(self, *options):
        controller = Controller(PROGRAM, "--polyscope", "3.4", "--powered", *options)
        self.addCleanup(controller.close)
        robot = urx.urrobot.URRobot(controller.address)
        self.addCleanup(robot.close)
        return robot

    def await_true(self, condition):
        while not condition():  # ctest's timeout ends a test whose condition never holds
            time.sleep(0.01)

    def assertNear(self, found, expected, delta):
        for one, other in zip(found, expected, strict=True):
            self.assertAlmostEqual(one, other, delta=delta)

    def test_reads_the_secondary_interface(self):
        robot = self.robot()
        self.assertEqual(robot.secmon._parser.version, (3, 2))
        self.assertTrue(robot.is_running())
        self.assertFalse(robot.is_program_running())
        self.assertNear(robot.getj(), HOME, 1e-12)
        data = robot.secmon.get_all_data(wait=True)
        mode = data["RobotModeData"]
        self.assertEqual((mode["robotMode"], mode["isPowerOnRobot"], mode["isSecurityStopped"]), (7, True, False))
        self.assertEqual([data["JointData"][f"jointMode{i}"] for i in range(6)], [253] * 6)
        self.assertEqual(data["MasterBoardData"]["robotVoltage48V"], 48)
        self.assertNear([data["CartesianInfo"]["tcpOffset" + axis] for axis in ("X", "Y", "Z", "Rx", "Ry", "Rz")], [0] * 6, 0)

    def test_moves(self):
        robot = self.robot()
        before = robot.getl(wait=True)
        target = [0.3, -1.5, 1.4, -1.5, -1.5, -0.2]
        self.assertNear(robot.movej(target, acc=4, vel=2), target, 2e-3)
        after = robot.getl(wait=True)
        self.assertGreater(math.dist(before[:3], after[:3]), 0.05)
        robot.movej([1.3, *target[1:]], acc=4, vel=0.5, wait=False)
        self.await_true(lambda: robot.getj(wait=True)[0] > 0.4)
        robot.stopj(10)
        self.await_true(lambda: robot.secmon.get_joint_data(wait=True)["qd_actual0"] < 1e-3)
        self.assertLess(robot.getj(wait=True)[0], 1.25)

    def test_terminals(self):
        robot = self.robot()
        robot.set_digital_out(3, True)
        self.await_true(lambda: robot.get_digital_out(3, wait=True))
        self.assertFalse(robot.get_digital_out(2))
        robot.set_analog_out(1, 0.5)
        self.await_true(lambda: robot.secmon.get_all_data(wait=True)["MasterBoardData"]["analogOutput1"] == 5)
        self.assertEqual(robot.get_digital_in_bits(), 0)

    def test_sets_the_tool(self):
        robot = self.robot()
        flange = robot.getl(wait=True)
        robot.set_tcp((0, 0, 0.1, 0, 0, 0))
        self.await_true(lambda: robot.secmon.get_cartesian_info(wait=True)["tcpOffsetZ"] == 0.1)
        self.assertAlmostEqual(math.dist(robot.getl()[:3], flange[:3]), 0.1, delta=1e-9)

    def test_reads_the_wrench_of_the_real_time_interface(self):
        robot = self.robot("--load", *map(str, LOAD))
        monitor = robot.get_realtime_monitor()
        wrench = monitor.tcf_force(wait=True)
        self.assertAlmostEqual(robot.get_force(), math.hypot(*LOAD), delta=1e-9)
        self.assertAlmostEqual(math.hypot(*wrench[:3]), math.hypot(*LOAD[:3]), delta=1e-9)
        self.assertNear(monitor.q_actual(wait=True), HOME, 1e-12)
        self.assertNear(monitor.tcf_pose(wait=True), robot.getl(wait=True), 1e-12)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2, warnings="ignore")  # of Condition.notifyAll
