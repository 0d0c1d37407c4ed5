"""A client of control_msgs/action/FollowJointTrajectory by Cyclone DDS 11, with its own description of the types."""

import dataclasses
import random
import time
import uuid

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct, types
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

TIMEOUT = 60  # s
RELIABLE = Policy.Reliability.Reliable(duration(seconds=1))
SERVICE = Qos(RELIABLE, Policy.History.KeepLast(10))
FEEDBACK = Qos(RELIABLE, Policy.History.KeepLast(10))
STATUS = Qos(RELIABLE, Policy.History.KeepLast(1), Policy.Durability.TransientLocal)
UNKNOWN, ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = range(7)
SUCCESSFUL, INVALID_GOAL, INVALID_JOINTS, OLD_HEADER_TIMESTAMP, PATH_TOLERANCE_VIOLATED, GOAL_TOLERANCE_VIOLATED = range(0, -6, -1)
NO_IDENTITY = [0] * 16


@dataclasses.dataclass
class Moment(IdlStruct):  # a time or a duration
    sec: types.int32 = 0
    nanosec: types.uint32 = 0


@dataclasses.dataclass
class Header(IdlStruct):
    stamp: Moment = dataclasses.field(default_factory=Moment)
    frame_id: str = ""


@dataclasses.dataclass
class Vector3(IdlStruct):
    x: types.float64 = 0
    y: types.float64 = 0
    z: types.float64 = 0


@dataclasses.dataclass
class Quaternion(IdlStruct):
    x: types.float64 = 0
    y: types.float64 = 0
    z: types.float64 = 0
    w: types.float64 = 1


@dataclasses.dataclass
class Transform(IdlStruct):
    translation: Vector3 = dataclasses.field(default_factory=Vector3)
    rotation: Quaternion = dataclasses.field(default_factory=Quaternion)


@dataclasses.dataclass
class Twist(IdlStruct):
    linear: Vector3 = dataclasses.field(default_factory=Vector3)
    angular: Vector3 = dataclasses.field(default_factory=Vector3)


@dataclasses.dataclass
class Point(IdlStruct):
    positions: types.sequence[types.float64] = dataclasses.field(default_factory=list)
    velocities: types.sequence[types.float64] = dataclasses.field(default_factory=list)
    accelerations: types.sequence[types.float64] = dataclasses.field(default_factory=list)
    effort: types.sequence[types.float64] = dataclasses.field(default_factory=list)
    time_from_start: Moment = dataclasses.field(default_factory=Moment)


@dataclasses.dataclass
class Trajectory(IdlStruct):
    header: Header = dataclasses.field(default_factory=Header)
    joint_names: types.sequence[str] = dataclasses.field(default_factory=list)
    points: types.sequence[Point] = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class MultiDofPoint(IdlStruct):
    transforms: types.sequence[Transform] = dataclasses.field(default_factory=list)
    velocities: types.sequence[Twist] = dataclasses.field(default_factory=list)
    accelerations: types.sequence[Twist] = dataclasses.field(default_factory=list)
    time_from_start: Moment = dataclasses.field(default_factory=Moment)


@dataclasses.dataclass
class MultiDofTrajectory(IdlStruct):
    header: Header = dataclasses.field(default_factory=Header)
    joint_names: types.sequence[str] = dataclasses.field(default_factory=list)
    points: types.sequence[MultiDofPoint] = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Tolerance(IdlStruct):
    name: str
    position: types.float64 = 0
    velocity: types.float64 = 0
    acceleration: types.float64 = 0


@dataclasses.dataclass
class ComponentTolerance(IdlStruct):
    joint_name: str
    component: types.uint16
    position: types.float64
    velocity: types.float64
    acceleration: types.float64


@dataclasses.dataclass
class Goal(IdlStruct):
    trajectory: Trajectory = dataclasses.field(default_factory=Trajectory)
    multi_dof_trajectory: MultiDofTrajectory = dataclasses.field(default_factory=MultiDofTrajectory)
    path_tolerance: types.sequence[Tolerance] = dataclasses.field(default_factory=list)
    component_path_tolerance: types.sequence[ComponentTolerance] = dataclasses.field(default_factory=list)
    goal_tolerance: types.sequence[Tolerance] = dataclasses.field(default_factory=list)
    component_goal_tolerance: types.sequence[ComponentTolerance] = dataclasses.field(default_factory=list)
    goal_time_tolerance: Moment = dataclasses.field(default_factory=Moment)


@dataclasses.dataclass
class GoalRequest(IdlStruct, typename="control_msgs.action.dds_.FollowJointTrajectory_SendGoal_Request_"):
    client: types.uint64
    sequence: types.int64
    goal_id: types.array[types.uint8, 16]
    goal: Goal


@dataclasses.dataclass
class GoalReply(IdlStruct, typename="control_msgs.action.dds_.FollowJointTrajectory_SendGoal_Response_"):
    client: types.uint64
    sequence: types.int64
    accepted: bool
    stamp: Moment


@dataclasses.dataclass
class ResultRequest(IdlStruct, typename="control_msgs.action.dds_.FollowJointTrajectory_GetResult_Request_"):
    client: types.uint64
    sequence: types.int64
    goal_id: types.array[types.uint8, 16]


@dataclasses.dataclass
class ResultReply(IdlStruct, typename="control_msgs.action.dds_.FollowJointTrajectory_GetResult_Response_"):
    client: types.uint64
    sequence: types.int64
    status: types.int8
    error_code: types.int32
    error_string: str


@dataclasses.dataclass
class GoalInfo(IdlStruct):
    goal_id: types.array[types.uint8, 16]
    stamp: Moment = dataclasses.field(default_factory=Moment)


@dataclasses.dataclass
class CancelRequest(IdlStruct, typename="action_msgs.srv.dds_.CancelGoal_Request_"):
    client: types.uint64
    sequence: types.int64
    goal_info: GoalInfo


@dataclasses.dataclass
class CancelReply(IdlStruct, typename="action_msgs.srv.dds_.CancelGoal_Response_"):
    client: types.uint64
    sequence: types.int64
    return_code: types.int8
    goals_canceling: types.sequence[GoalInfo]


@dataclasses.dataclass
class GoalStatus(IdlStruct):
    goal_info: GoalInfo
    status: types.int8


@dataclasses.dataclass
class StatusArray(IdlStruct, typename="action_msgs.msg.dds_.GoalStatusArray_"):
    status_list: types.sequence[GoalStatus]


@dataclasses.dataclass
class Feedback(IdlStruct, typename="control_msgs.action.dds_.FollowJointTrajectory_FeedbackMessage_"):  # until Jazzy
    goal_id: types.array[types.uint8, 16]
    header: Header
    joint_names: types.sequence[str]
    desired: Point
    actual: Point
    error: Point
    multi_dof_joint_names: types.sequence[str]
    multi_dof_desired: MultiDofPoint
    multi_dof_actual: MultiDofPoint
    multi_dof_error: MultiDofPoint


def moment(seconds):
    return Moment(int(seconds), round((seconds - int(seconds)) * 1e9))


def goal_of(joints, points, **fields):
    """`points`: times and positions, by the names of `joints`."""
    return Goal(Trajectory(Header(), list(joints), [Point(positions=list(values), time_from_start=moment(at)) for at, values in points]), **fields)


class ActionClient:
    def __init__(self, domain, action):
        self.participant = DomainParticipant(domain)
        self.id = random.getrandbits(63)
        self.last = 0
        self.services = {}
        name = f"{action}/_action/"
        for part, request, reply in (("send_goal", GoalRequest, GoalReply), ("get_result", ResultRequest, ResultReply),
                                     ("cancel_goal", CancelRequest, CancelReply)):
            writer = DataWriter(self.participant, Topic(self.participant, f"rq{name}{part}Request", request), qos=SERVICE)
            reader = DataReader(self.participant, Topic(self.participant, f"rr{name}{part}Reply", reply), qos=SERVICE)
            self.services[part] = (request, writer, reader)
        self.feedback = DataReader(self.participant, Topic(self.participant, f"rt{name}feedback", Feedback), qos=FEEDBACK)
        self.status = DataReader(self.participant, Topic(self.participant, f"rt{name}status", StatusArray), qos=STATUS)
        self.received = []  # replies that are not yet asked for
        end = time.monotonic() + TIMEOUT
        while not all(writer.get_matched_subscriptions() and reader.get_matched_publications() for _, writer, reader in self.services.values()):
            assert time.monotonic() < end, f"{action} is not there"
            time.sleep(0.02)
        time.sleep(0.2)  # the server has matched the readers of its replies, too

    def send(self, part, *fields):
        request, writer, _ = self.services[part]
        self.last += 1
        writer.write(request(self.id, self.last, *fields))
        return self.last

    def reply(self, number, timeout=TIMEOUT):
        """To this request of this client."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            for _, _, reader in self.services.values():
                self.received += [sample for sample in reader.take(N=10) if getattr(sample, "client", None) == self.id]
            for sample in self.received:
                if sample.sequence == number:
                    self.received.remove(sample)
                    return sample
            time.sleep(0.01)
        raise AssertionError(f"no reply to request {number}")

    def start(self, goal, identity=None):
        """Whether a goal is accepted, its identity, and the request of its result."""
        identity = identity or list(uuid.uuid4().bytes)
        reply = self.reply(self.send("send_goal", identity, goal))
        return reply.accepted, identity, self.send("get_result", identity)

    def cancel(self, identity, stamp=None):
        return self.reply(self.send("cancel_goal", GoalInfo(identity, stamp or Moment())))

    def next_feedback(self):
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            for sample in self.feedback.take(N=1):
                if hasattr(sample, "joint_names"):
                    return sample
            time.sleep(0.01)
        raise AssertionError("no feedback")

    def status_of(self, identity):
        """The newest status of a goal, without waiting."""
        status = UNKNOWN
        for sample in self.status.read(N=10):
            for each in getattr(sample, "status_list", []):
                if bytes(each.goal_info.goal_id) == bytes(identity):
                    status = each.status
        return status
