#!/usr/bin/env python3
"""Tests the simulated UR controller with the third-party client ur_rtde.

The client's ports are fixed, so each controller listens on a loopback address of its own.

Usage: client_test.py UR_CONTROLLER
"""

import math
import sys
import time
import unittest

import dashboard_client
import rtde_control
import rtde_io
import rtde_receive

from controller import Controller

HOME = [0, -1.5, 1.5, -1.5, -1.5, 0]
POWER_OFF, IDLE, RUNNING = 3, 5, 7
NORMAL = 1
PROGRAM = ""


class ClientTest(unittest.TestCase):
    def controller(self, *options):
        controller = Controller(PROGRAM, *options)
        self.addCleanup(controller.close)
        return controller.address

    def receiver(self, address, frequency=500.0):
        receiver = rtde_receive.RTDEReceiveInterface(address, frequency)
        self.addCleanup(receiver.disconnect)
        return receiver

    def assertNear(self, found, expected, delta):
        for one, other in zip(found, expected, strict=True):
            self.assertAlmostEqual(one, other, delta=delta)

    def await_true(self, condition):
        while not condition():  # ctest's timeout ends a test whose condition never holds
            time.sleep(0.002)

    def test_reads_the_state(self):
        address = self.controller("--powered")
        for frequency in (500.0, 125.0):
            with self.subTest(frequency=frequency):
                receiver = self.receiver(address, frequency)
                self.assertNear(receiver.getActualQ(), HOME, 1e-12)
                self.assertNear(receiver.getActualQd(), [0] * 6, 1e-12)
                self.assertEqual(receiver.getRobotMode(), RUNNING)
                self.assertEqual(receiver.getSafetyMode(), NORMAL)
                self.assertEqual(receiver.getRobotStatus(), 1)
                self.assertEqual(receiver.getJointMode(), [253] * 6)
                self.assertEqual(receiver.getRuntimeState(), 1)
                self.assertEqual(len(receiver.getActualTCPPose()), 6)

    def test_reads_tool_and_wrench(self):
        # along the flange's z axis, whose direction in the base frame follows from the pose
        load = [0, 0, 25, 0, 0, 0]
        receiver = self.receiver(self.controller("--powered", "--load", *map(str, load)))
        pose, force = receiver.getActualTCPPose(), receiver.getActualTCPForce()
        self.assertAlmostEqual(math.hypot(*force[:3]), 25, delta=1e-9)
        self.assertNear(force[3:], [0, 0, 0], 1e-9)
        angle = math.hypot(*pose[3:])
        axis = [each / angle for each in pose[3:]]
        # the third column of the rotation by `angle` about `axis`: where the flange points
        z = [(1 - math.cos(angle)) * axis[0] * axis[2] + math.sin(angle) * axis[1],
             (1 - math.cos(angle)) * axis[1] * axis[2] - math.sin(angle) * axis[0],
             math.cos(angle) + (1 - math.cos(angle)) * axis[2] ** 2]
        self.assertNear(force[:3], [25 * each for each in z], 1e-9)

    def test_sends_at_each_frequency(self):
        address = self.controller()
        for frequency in (500.0, 125.0):
            with self.subTest(frequency=frequency):
                receiver = self.receiver(address, frequency)
                times = set()
                while len(times) < 100:
                    times.add(round(receiver.getTimestamp() / 0.002))
                    time.sleep(0.0002)
                between = 500 / frequency
                steps = [later - earlier for earlier, later in zip(sorted(times), sorted(times)[1:])]
                # a client that sleeps too long misses packages, but none come between
                self.assertTrue(all(step % between == 0 for step in steps), steps)
                self.assertIn(between, steps)

    def test_dashboard(self):
        address = self.controller()
        receiver = self.receiver(address)
        self.assertEqual(receiver.getRobotMode(), POWER_OFF)
        dashboard = dashboard_client.DashboardClient(address)
        dashboard.connect()
        self.addCleanup(dashboard.disconnect)
        self.assertEqual(dashboard.robotmode(), "Robotmode: POWER_OFF")
        self.assertEqual(dashboard.safetystatus(), "Safetystatus: NORMAL")
        self.assertTrue(dashboard.isInRemoteControl())
        self.assertFalse(dashboard.running())
        dashboard.powerOn()
        self.await_true(lambda: receiver.getRobotMode() == IDLE)
        dashboard.brakeRelease()
        self.await_true(lambda: receiver.getRobotMode() == RUNNING)
        self.assertEqual(receiver.getJointMode(), [253] * 6)

    def test_moves(self):
        address = self.controller("--powered")
        control = rtde_control.RTDEControlInterface(address, 500.0)
        self.addCleanup(control.disconnect)
        receiver = self.receiver(address)
        self.assertTrue(control.isProgramRunning())
        target = [0.3, -1.5, 1.4, -1.5, -1.5, -0.2]
        self.assertTrue(control.moveJ(target, 2.0, 4.0))
        self.await_true(lambda: max(abs(rate) for rate in receiver.getActualQd()) < 1e-2)
        self.assertNear(receiver.getActualQ(), target, 2e-3)
        for _ in range(100):
            begin = control.initPeriod()
            target[1] += 0.001
            self.assertTrue(control.servoJ(target, 0, 0, 0.002, 0.1, 300))
            control.waitPeriod(begin)
        self.await_true(lambda: abs(receiver.getActualQ()[1] - target[1]) < 1e-3)
        self.assertTrue(control.servoStop())
        before = receiver.getActualQ()[2]
        self.assertTrue(control.speedJ([0, 0, 0.2, 0, 0, 0], 1.0, 0.1))
        self.await_true(lambda: receiver.getActualQ()[2] > before + 0.02)
        self.assertTrue(control.speedStop(10.0))
        self.await_true(lambda: abs(receiver.getActualQd()[2]) < 1e-2)
        control.stopScript()
        self.await_true(lambda: not control.isProgramRunning())

    def test_terminals(self):
        address = self.controller("--powered")
        receiver = self.receiver(address)
        terminals = rtde_io.RTDEIOInterface(address)
        self.addCleanup(terminals.disconnect)
        self.assertTrue(terminals.setStandardDigitalOut(3, True))
        self.await_true(lambda: receiver.getDigitalOutState(3))
        self.assertFalse(receiver.getDigitalOutState(2))
        self.assertTrue(terminals.setStandardDigitalOut(2, True))
        self.await_true(lambda: receiver.getDigitalOutState(2))
        self.assertTrue(receiver.getDigitalOutState(3))
        self.assertTrue(terminals.setAnalogOutputVoltage(1, 0.5))
        self.await_true(lambda: abs(receiver.getStandardAnalogOutput1() - 5) < 1e-9)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2)
