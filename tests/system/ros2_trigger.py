"""Peers of the bridge to ROS 2 by Cyclone DDS 11: endpoints as discovery has them, and a client of std_srvs/srv/Trigger."""

import dataclasses
import random
import time

from cyclonedds.builtin import BuiltinDataReader, BuiltinTopicDcpsPublication
from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct, types
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

TIMEOUT = 60  # s
QOS = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(10))


@dataclasses.dataclass
class Request(IdlStruct, typename="std_srvs.srv.dds_.Trigger_Request_"):
    client: types.uint64
    sequence: types.int64
    structure_needs_at_least_one_member: types.uint8


@dataclasses.dataclass
class Reply(IdlStruct, typename="std_srvs.srv.dds_.Trigger_Response_"):
    client: types.uint64
    sequence: types.int64
    success: bool
    message: str


def endpoints(domain, wanted):
    """Of each writer's topic: its type's name and its user data. Returns when the wanted topics are there."""
    participant = DomainParticipant(domain)
    reader = BuiltinDataReader(participant, BuiltinTopicDcpsPublication)
    found = {}
    end = time.monotonic() + TIMEOUT
    while not wanted <= found.keys():
        assert time.monotonic() < end, f"only {sorted(found)}"
        for sample in reader.take(N=100):
            if hasattr(sample, "topic_name"):
                data = sample.qos[Policy.Userdata].data if Policy.Userdata in sample.qos else b""
                found[sample.topic_name] = (sample.type_name, bytes(data).decode())
        time.sleep(0.02)
    return found


class TriggerClient:
    def __init__(self, domain):
        self.participant = DomainParticipant(domain)
        self.id = random.getrandbits(63)
        self.ends = {}
        self.last = 0

    def connect(self, service):
        if service not in self.ends:
            request = Topic(self.participant, f"rq{service}Request", Request)
            reply = Topic(self.participant, f"rr{service}Reply", Reply)
            writer, reader = DataWriter(self.participant, request, qos=QOS), DataReader(self.participant, reply, qos=QOS)
            end = time.monotonic() + TIMEOUT
            while not (writer.get_matched_subscriptions() and reader.get_matched_publications()):
                assert time.monotonic() < end, f"{service} is not there"
                time.sleep(0.02)
            time.sleep(0.2)  # the service has matched the reader of its replies, too
            self.ends[service] = (writer, reader)
        return self.ends[service]

    def send(self, service):
        writer, _ = self.connect(service)
        self.last += 1
        writer.write(Request(self.id, self.last, 0))
        return self.last

    def reply(self, service, number):
        """Success and message of the reply to this request of this client."""
        _, reader = self.connect(service)
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            for sample in reader.take(N=10):
                if (sample.client, sample.sequence) == (self.id, number):
                    return sample.success, sample.message
            time.sleep(0.02)
        raise AssertionError(f"no reply of {service}")

    def call(self, service):
        return self.reply(service, self.send(service))
