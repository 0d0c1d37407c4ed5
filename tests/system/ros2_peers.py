"""What the tests of the bridge to ROS 2 share: a network of their own, runs of deployments, and the peers rosless and Cyclone DDS 11.

The program's arguments are BUILD_FOLDER SOURCE_FOLDER [NAME...].
"""

import os
import pathlib
import random
import re
import signal
import socket
import struct
import subprocess
import sys
import threading
import time

BUILD, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
PRESS = SOURCE / "tasks/press/press.toml"
DOMAIN = 7  # in a network of this process's own
TIMEOUT = 120

# a card that takes multicast, as a lab's has
NETWORK = ("ip link set lo up && ip link add lab type veth peer name other && ip address add 10.20.30.1/24 dev lab && "
           "ip link set other up && ip link set lab up && ip route add default dev lab")


def enter_network():
    """Starts this program again in a network namespace of its own, once."""
    if os.environ.get("MRROC_TEST_NETWORK"):
        return
    os.environ["MRROC_TEST_NETWORK"] = "lab"
    os.environ["ROS_DOMAIN_ID"] = str(DOMAIN)
    words = ["unshare", "--user", "--map-root-user", "--net", "--", "sh", "-c", NETWORK + ' && exec "$@"', "sh", sys.executable, *sys.argv]
    os.execvp(words[0], words)


class Run:
    """`mrroc run` of a deployment with a bridge, in its own folder for sockets."""

    def __init__(self, folder, deployment, *words):
        self.log = folder / "log"
        self.environment = dict(os.environ, MRROC_RUNTIME_DIR=str(folder / "sockets"))
        with open(self.log, "w", encoding="utf-8") as log:
            self.process = subprocess.Popen(
                [BUILD / "bin/mrroc", "run", deployment, "--black-box=", *map(str, words)], stdout=log, stderr=subprocess.STDOUT,
                stdin=subprocess.DEVNULL, cwd=SOURCE, env=self.environment)

    def text(self):
        return self.log.read_text(encoding="utf-8")

    def wait_for(self, pattern):
        end = time.monotonic() + TIMEOUT
        while not (found := re.search(pattern, self.text(), re.MULTILINE)):
            assert time.monotonic() < end and self.process.poll() is None, f"no '{pattern}' in:\n{self.text()}"
            time.sleep(0.02)
        return found

    def operate(self, verb):
        subprocess.run([BUILD / "bin/mrroc", verb], env=self.environment, check=True, capture_output=True)

    def children(self):
        listed = pathlib.Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children").read_text(encoding="utf-8")
        return list(map(int, listed.split()))

    def bridge(self):
        """The process of the bridge: the child of the run with this program."""
        for child in self.children():
            if pathlib.Path(f"/proc/{child}/exe").resolve().name == "mrroc_ros2":
                return child
        raise AssertionError(f"no bridge among {self.children()}")

    def end(self, expected=0):
        code = self.process.wait(timeout=TIMEOUT)
        assert code == expected, f"exit code {code}, expected {expected}\n{self.text()}"
        return self.text()

    def close(self):
        if self.process.poll() is not None:
            return
        children = self.children()
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()
        # the next run's domain is the same: its endpoints must be those of that run alone
        end = time.monotonic() + TIMEOUT
        while any(pathlib.Path(f"/proc/{child}/exe").exists() for child in children):  # a zombie has none
            assert time.monotonic() < end, f"processes {children} of a killed run"
            time.sleep(0.02)


def udp_ports(pid):
    """Of a process's sockets, without those for multicast, which other nodes of the domain have, too."""
    inodes = {link.readlink().name for link in pathlib.Path(f"/proc/{pid}/fd").iterdir() if str(link.readlink()).startswith("socket:")}
    rows = [row.split() for row in pathlib.Path(f"/proc/{pid}/net/udp").read_text(encoding="utf-8").splitlines()[1:]]
    ports = {int(row[1].split(":")[1], 16) for row in rows if f"socket:[{row[9]}]" in inodes}
    return sorted(port for port in ports if port - 7400 - 250 * DOMAIN not in (0, 1))


def datagrams_for_sockets():
    """Of this network, so far: those that a socket has received, or had no place for."""
    names, values = (row.split()[1:] for row in pathlib.Path("/proc/self/net/snmp").read_text(encoding="utf-8").splitlines() if row.startswith("Udp:"))
    counts = dict(zip(names, map(int, values)))
    return counts["InDatagrams"] + counts["RcvbufErrors"]


class Flood:
    """Datagrams to these ports of this machine, as many as one thread sends, each of them random bytes behind an RTPS header."""

    UDP_SEGMENT = 103  # of linux/udp.h: the kernel cuts what is sent at once into datagrams of this size
    AT_ONCE = 60

    def __init__(self, ports):
        self.ports, self.sent, self.ending = ports, 0, False
        self.begin, self.before = time.monotonic(), datagrams_for_sockets()
        self.thread = threading.Thread(target=self.send)
        self.thread.start()

    def send(self):
        draw = random.Random(17)
        bursts = []
        for size in [20, 48, 408] * 40:
            datagrams = [b"RTPS\x02\x01\x01\x10" + draw.randbytes(size - 8) for _ in range(self.AT_ONCE)]
            bursts.append((b"".join(datagrams), [(socket.IPPROTO_UDP, self.UDP_SEGMENT, struct.pack("H", size))]))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            while not self.ending:
                for burst, size in bursts:
                    for port in self.ports:
                        sender.sendmsg([burst], size, 0, ("10.20.30.1", port))
                        self.sent += self.AT_ONCE

    def end(self):
        """How many have come to the sockets, and how many in a second."""
        self.ending = True
        self.thread.join()
        arrived = min(self.sent, datagrams_for_sockets() - self.before)
        return arrived, arrived / (time.monotonic() - self.begin)


def hash_of(recording):
    done = subprocess.run([BUILD / "bin/mrroc", "trace", "hash", recording], capture_output=True, text=True, check=True)
    return done.stdout.split()[0]
