"""Two arms whose controllers keep the time, each with a clock of its own, and one on the deployment's, in one Move.

robot_clocks_test.py BUILD_FOLDER SOURCE_FOLDER
"""

import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest

BUILD, SOURCE = (pathlib.Path(folder).resolve() for folder in sys.argv[1:3])
TIMEOUT = 120
RATES = {"slow": 0.9998, "fast": 1.0003}
HOME = ("0", "-1.747780928", "0.4768189", "-0.299834299", "4.71238898", "1.57079633")  # of robots/irb6/irb6.toml
UR = """[robots.{name}]
type = "irb6"
parameters = "arm.toml"
hardware = "ur"
[robots.{name}.ur]
address = "127.0.0.1"
rtde_port = {0}
dashboard_port = {1}
script_port = {2}
watchdog = 2.0
missed_max = 400
"""
DEPLOYMENT = """[deployment]
name = "robot_clocks"
clock = "real"
[mp]
program = "{}/tests/robot_clocks_mp"
{}
[robots.common]
type = "irb6"
hardware = "loopback"
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class RobotClocks(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        os.environ["MRROC_RUNTIME_DIR"] = f"{self.folder}/mrroc"
        self.controllers = []

    def tearDown(self):
        for controller in self.controllers:
            controller.terminate()
            controller.communicate()
        shutil.rmtree(self.folder)

    def start_controller(self, rate):
        ports = free_ports(3)
        command = [BUILD / "bin/ur_controller", "--clock-rate", str(rate), "--joints", *HOME, "--primary-port", "0", "--realtime-port", "0"]
        for name, port in zip(("rtde", "dashboard", "secondary"), ports):
            command += [f"--{name}-port", str(port)]
        controller = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.controllers.append(controller)
        self.assertIn("RTDE", controller.stdout.readline())
        return ports

    def test_three_clocks_share_the_grid(self):
        arm = (SOURCE / "robots/irb6/irb6.toml").read_text(encoding="utf-8")
        (self.folder / "arm.toml").write_text(
            'drives = { regulates = "itself", interface = "position", bandwidth = 20.0 }\n' + arm, encoding="utf-8")
        arms = "".join(UR.format(*self.start_controller(rate), name=name) for name, rate in RATES.items())
        deployment = self.folder / "deployment.toml"
        deployment.write_text(DEPLOYMENT.format(BUILD, arms), encoding="utf-8")
        done = subprocess.run([BUILD / "bin/mrroc", "run", deployment, "--black-box="], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True, timeout=TIMEOUT, check=False)
        print(done.stdout)
        self.assertEqual(done.returncode, 0)
        skews = [int(skew) for skew in re.findall(r"mp \| skew (\d+) ticks", done.stdout)]
        self.assertEqual(len(skews), 6)
        # a command that a busy machine delivers late is that of one robot: only then robots are out of step
        late = sum(int(count) for count in re.findall(r"(\d+) late commands", done.stdout))
        self.assertLessEqual(sum(skew != 0 for skew in skews), late)
        for name in RATES:
            line = re.search(rf"  {name}_edp +(\d+) ticks, .*\n +(\d+) packages of its clock, (\d+) lost, (\d+) doubled", done.stdout)
            self.assertIsNotNone(line, name)
            self.assertGreater(int(line[1]), 1000)
            self.assertGreater(int(line[2]), 1000)
            self.assertEqual((line[3], line[4]), ("0", "0"))
        self.assertIsNone(re.search(r"  common_edp .*\n +\d+ packages", done.stdout), "it has no clock of its own")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
