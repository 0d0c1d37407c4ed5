"""Topics as rosless receives them."""

import time

import rosless
from ros2_peers import DOMAIN

SILENT = 10  # s
# rosless aligns an empty sequence of numbers, which CDR does not: the last field is only its count
rosless.register_type("sensor_msgs/msg/JointState",
                      "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nuint32 effort_count")


class Readers:
    """Readers of one node of rosless, `topics`: name -> (type, qos).

    On a busy machine such a node at times hands over nothing of what arrives at its port, in none of its readers, for as
    long as it lives: a node without any message for SILENT is replaced by another one.
    """

    def __init__(self, topics):
        self.topics = topics
        self.join()

    def join(self):
        node = rosless.Node(DOMAIN)
        self.readers = {name: node.subscribe(name, kind, wait=0.0, **qos) for name, (kind, qos) in self.topics.items()}
        self.joined, self.served = time.monotonic(), False

    def read(self, timeout):
        """The next message of each topic that has one; waits for each at most `timeout` (s)."""
        messages = {name: reader.read(timeout=timeout) for name, reader in self.readers.items()}
        found = {name: message for name, message in messages.items() if message is not None}
        self.served = self.served or bool(found)
        if not self.served and time.monotonic() > self.joined + SILENT:
            self.join()
        return found
