"""A simulated UR controller on an address of loopback that no other has."""

import random
import subprocess


class Controller:
    def __init__(self, program, *options):
        for _ in range(20):
            self.address = "127.%d.%d.%d" % tuple(random.randrange(2, 250) for _ in range(3))
            self.process = subprocess.Popen([program, "--address", self.address, *options], stdout=subprocess.PIPE, text=True)
            if self.process.stdout.readline().startswith("RTDE"):
                return
            self.close()
        raise RuntimeError("no free loopback address")

    def close(self):
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close()
