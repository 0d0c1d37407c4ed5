#!/usr/bin/env python3
"""Tests the simulated Net F/T with two clients that others have written: NetFT and pynetft.

Usage: clients_test.py NETFT_SENSOR
"""

import os
import socket
import struct
import subprocess
import sys
import time
import unittest
import urllib.error
import urllib.request

import NetFT
import pynetft

SENSOR = sys.argv.pop(1)
TIMEOUT = 30  # s; long, so that a busy machine does not cause a failure
LOAD = (12.5, -3.25, 40.0, 0.5, -1.5, 2.0)
RDT_PORT = 49152  # NetFT knows no other


def own_loopback():
    """A loopback address that no other run of this test uses, because the port is given."""
    number = os.getpid()
    return f"127.{64 + number // 65536 % 64}.{number // 256 % 256}.{number % 254 + 1}"


class Sensor:
    """The process of a simulated sensor."""

    def __init__(self, *options):
        self.address = own_loopback()
        command = [SENSOR, "--address", self.address, "--http-port", "0", *options]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        words = self.process.stdout.readline().replace(",", "").split()
        self.http_port = int(words[-1])

    def tell(self, command):
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        assert answer == "done\n", answer

    def close(self):
        self.process.communicate()


class ClientsTest(unittest.TestCase):
    def sensor(self, *options):
        sensor = Sensor("--load", *map(str, LOAD), *options)
        self.addCleanup(sensor.close)
        return sensor

    def assert_eventually(self, condition):
        deadline = time.monotonic() + TIMEOUT
        while not condition():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def netft(self, sensor):
        client = NetFT.Sensor(sensor.address)
        self.addCleanup(client.sock.close)
        client.sock.settimeout(TIMEOUT)
        return client

    def pynetft(self, sensor, **options):
        config = pynetft.Config(sensor_host=sensor.address, http_port=sensor.http_port, receive_timeout=1.0,
                                configuration_connect_timeout=TIMEOUT, configuration_timeout=TIMEOUT, **options)
        client = pynetft.Client(config)
        client.start()
        self.addCleanup(client.stop)
        self.assertTrue(client.wait_for_first_sample(TIMEOUT))
        return client

    def test_netft_measures_the_load(self):
        client = self.netft(self.sensor())
        self.assertEqual(client.getMeasurement(), [round(1e6 * value) for value in LOAD])
        self.assertEqual(client.getForce(), [round(1e6 * value) for value in LOAD[:3]])
        self.assertEqual(client.getTorque(), [round(1e6 * value) for value in LOAD[3:]])

    def test_netft_gets_the_number_of_records_that_it_requests(self):
        client = self.netft(self.sensor())
        self.assertEqual(client.tare(10), [round(1e6 * value) for value in LOAD])
        self.assertEqual(client.getMeasurement(), [0] * 6)
        client.sock.settimeout(0.2)
        with self.assertRaises(TimeoutError):
            client.receive()

    def test_netft_streams_until_it_stops(self):
        sensor = self.sensor()
        client = self.netft(sensor)
        client.startStreaming(handler=False)
        for _ in range(1000):
            client.receive()
        sensor.tell("load 1 2 3 4 5 6")
        self.assert_eventually(lambda: client.receive() == [1000000 * value for value in range(1, 7)])
        client.stopStreaming()
        client.sock.settimeout(0.5)
        with self.assertRaises(TimeoutError):
            for _ in range(100000):
                client.receive()

    def test_netft_receives_software_bias(self):
        client = self.netft(self.sensor())
        client.send(0x42)
        self.assertEqual(client.getMeasurement(), [0] * 6)

    def test_pynetft_discovers_counts_and_units(self):
        sensor = self.sensor("--counts-per-force", "10000", "--counts-per-torque", "2000", "--force-unit", "lbf",
                             "--torque-unit", "lbf-in")
        client = self.pynetft(sensor)
        sample = client.latest_sample()
        self.assertEqual((sample.force_unit, sample.torque_unit), (pynetft.ForceUnit.POUND_FORCE,
                                                                   pynetft.TorqueUnit.POUND_FORCE_INCH))
        for value, load in zip(sample.force, LOAD[:3]):
            self.assertAlmostEqual(4.4482216152605 * value, load, delta=5e-4)
        for value, load in zip(sample.torque, LOAD[3:]):
            self.assertAlmostEqual(0.1129848290276167 * value, load, delta=1e-4)

    def test_pynetft_measures_the_load_and_its_bias(self):
        sensor = self.sensor()
        client = self.pynetft(sensor)
        sample = client.latest_sample()
        self.assertEqual(sample.wrench, LOAD)
        self.assertEqual(sample.status, 0)
        client.bias()
        self.assert_eventually(lambda: client.latest_sample().wrench == (0.0,) * 6)
        sensor.tell("load 13.5 -3.25 40 0.5 -1.5 2")
        self.assert_eventually(lambda: client.latest_sample().wrench == (1.0,) + (0.0,) * 5)

    def test_pynetft_counts_what_the_network_does(self):
        sensor = self.sensor()
        client = self.pynetft(sensor)
        for command, count in (("loss 0.05", "lost_count"), ("doubled 0.05", "duplicate_count"),
                               ("reordered 0.05", "out_of_order_count"), ("garbage 0.02", "malformed_count")):
            with self.subTest(command=command):
                before = getattr(client.health(), count)
                sensor.tell(command)
                self.assert_eventually(lambda: getattr(client.health(), count) > before + 10)
                sensor.tell("clear")

    def test_pynetft_reports_the_status(self):
        sensor = self.sensor()
        client = self.pynetft(sensor)
        sensor.tell("status 0x80020000")
        self.assert_eventually(lambda: client.health().device_error_count > 0)
        self.assertEqual(client.health().last_status, 0x80020000)

    def test_pynetft_finds_a_sensor_that_restarts(self):
        sensor = self.sensor()
        client = self.pynetft(sensor)
        # pynetft withholds measurements with a number below that of the last one: it waits for higher ones
        self.assert_eventually(lambda: client.latest_sample().ft_sequence > 5000)
        sensor.tell("restart")
        sensor.tell("load 1 2 3 4 5 6")
        self.assert_eventually(lambda: client.latest_sample().wrench == (1, 2, 3, 4, 5, 6))
        self.assertGreater(client.health().reconnect_count, 0)

    def test_buffered_packets_hold_consecutive_records(self):
        sensor = self.sensor("--buffer", "5")
        client = self.netft(sensor)
        client.send(3, 12)
        packets = [client.sock.recv(4096) for _ in range(3)]
        self.assertEqual([len(packet) for packet in packets], [180, 180, 72])
        records = list(struct.iter_unpack("!3I6i", b"".join(packets)))
        self.assertEqual([record[0] for record in records], list(range(1, 13)))
        self.assertTrue(all(record[3:] == tuple(round(1e6 * value) for value in LOAD) for record in records))

    def test_stream_of_one_client_ends_with_that_of_another(self):
        sensor = self.sensor("--one-client", "--rate", "100")
        clients = [self.netft(sensor) for _ in range(2)]
        for client in clients:
            client.startStreaming(handler=False)
            client.receive()
        clients[0].sock.settimeout(0.5)
        with self.assertRaises(TimeoutError):
            for _ in range(1000):
                clients[0].receive()
        clients[1].receive()

    def test_sensor_survives_foreign_packets(self):
        sensor = self.sensor()
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
            for packet in (b"", b"\x12", b"\x12\x34\x00\x01\x00\x00\x00\x00", bytes(2000)):
                other.sendto(packet, (sensor.address, RDT_PORT))
        with self.assertRaises(urllib.error.HTTPError):
            urllib.request.urlopen(f"http://{sensor.address}:{sensor.http_port}/", timeout=TIMEOUT)
        with socket.create_connection((sensor.address, sensor.http_port)) as other:
            other.sendall(bytes(10000))
        client = self.netft(sensor)
        self.assertEqual(client.getMeasurement(), [round(1e6 * value) for value in LOAD])


if __name__ == "__main__":
    unittest.main()
