#!/usr/bin/env python3
"""Tests the simulated UR controller with the third-party client urpy, whose RTDE part is the client that Universal Robots publishes.

Its port for programs is fixed, so each controller listens on a loopback address of its own.

Usage: urpy_test.py UR_CONTROLLER
"""

import pathlib
import sys
import tempfile
import time
import unittest

import urpy
from urpy.rtde import rtde

from controller import Controller

HOME = [0, -1.5, 1.5, -1.5, -1.5, 0]
RUNNING = 7
# the types of the RTDE guide
TYPES = {"timestamp": "DOUBLE", "actual_q": "VECTOR6D", "joint_mode": "VECTOR6INT32", "robot_mode": "INT32", "runtime_state": "UINT32",
         "actual_digital_output_bits": "UINT64", "elbow_position": "VECTOR3D", "output_int_register_24": "INT32",
         "input_double_register_30": "DOUBLE", "standard_analog_output1": "DOUBLE"}
CONFIGURATION = """<rtde_config><recipe key="out"><field name="actual_q" type="VECTOR6D"/><field name="actual_TCP_pose" type="VECTOR6D"/>
</recipe></rtde_config>"""
PROGRAM = ""
rtde.DEFAULT_TIMEOUT = 60.0  # s; a busy machine must not end a test


class UrpyTest(unittest.TestCase):
    def controller(self):
        controller = Controller(PROGRAM, "--powered")
        self.addCleanup(controller.close)
        return controller.address

    def connection(self, address):
        connection = rtde.RTDE(address)
        connection.connect()
        self.addCleanup(connection.disconnect)
        return connection

    def started(self, address, names=tuple(TYPES), frequency=500):
        connection = self.connection(address)
        self.assertTrue(connection.send_output_setup(names, [TYPES[name] for name in names], frequency))
        self.assertTrue(connection.send_start())
        return connection

    def await_state(self, connection, condition):
        while not condition(state := connection.receive()):  # ctest's timeout ends a test whose condition never holds
            pass
        return state

    def test_agrees_on_versions_and_types(self):
        connection = self.started(self.controller())
        self.assertEqual(connection.get_controller_version(), (5, 11, 1, 108318))
        state = connection.receive()
        self.assertEqual((state.actual_q, state.joint_mode, state.robot_mode), (HOME, [253] * 6, RUNNING))
        self.assertEqual(len(state.elbow_position), 3)

    def test_each_package_is_one_period(self):
        address = self.controller()
        for frequency, period in ((500, 0.002), (125, 0.008)):
            with self.subTest(frequency=frequency):
                connection = self.started(address, ("timestamp",), frequency)
                times = []
                while len(times) < 50:
                    if (state := connection.receive_buffered()) is not None:
                        times.append(state.timestamp)
                    else:
                        time.sleep(0.001)
                for earlier, later in zip(times, times[1:]):
                    self.assertAlmostEqual(later - earlier, period, delta=1e-9)

    def test_writes_registers_and_terminals(self):
        connection = self.connection(self.controller())
        registers = connection.send_input_setup(["input_double_register_30"], ["DOUBLE"])
        terminals = connection.send_input_setup(["standard_digital_output_mask", "standard_digital_output"], ["UINT8", "UINT8"])
        self.assertTrue(connection.send_output_setup(list(TYPES), list(TYPES.values()), 500))
        self.assertTrue(connection.send_start())
        registers.input_double_register_30 = -0.125
        self.assertTrue(connection.send(registers))
        self.await_state(connection, lambda state: state.input_double_register_30 == -0.125)
        terminals.standard_digital_output_mask, terminals.standard_digital_output = 0x0f, 0xfa
        self.assertTrue(connection.send(terminals))
        self.await_state(connection, lambda state: state.actual_digital_output_bits == 0x0a)

    def test_fields_that_are_in_use_or_unknown_are_refused(self):
        address = self.controller()
        first, second = self.connection(address), self.connection(address)
        self.assertIsNotNone(first.send_input_setup(["input_int_register_24"], ["INT32"]))
        with self.assertRaisesRegex(ValueError, "already in use"):
            second.send_input_setup(["input_int_register_24"])
        with self.assertRaisesRegex(ValueError, "NOT_FOUND"):
            second.send_output_setup(["actual_q", "actual_nonsense"])

    def test_pauses(self):
        connection = self.started(self.controller())
        self.assertTrue(connection.send_pause())
        while connection.receive_buffered() is not None:  # packages sent before the pause
            pass
        time.sleep(0.1)
        self.assertIsNone(connection.receive_buffered())
        self.assertTrue(connection.send_start())
        self.assertEqual(connection.receive().actual_q, HOME)

    def test_moves(self):
        address = self.controller()
        with tempfile.TemporaryDirectory() as folder:
            configuration = pathlib.Path(folder) / "configuration.xml"  # the package has none
            configuration.write_text(CONFIGURATION, encoding="utf-8")
            sys.argv[1:] = ["--config", str(configuration)]
            robot = urpy.UniversalRobot(address)
            robot.set_vel(2)
            before = robot.get_pose()
            target = urpy.JointPosition(0.3, -1.5, 1.4, -1.5, -1.5, -0.2)
            robot.move_to(target)
            self.assertEqual(robot.get_joint_position(), target)
            self.assertFalse(before._kinda_equal(robot.get_pose(), 50))  # mm


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2)
