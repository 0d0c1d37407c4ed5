"""Reads the steps of a recording: `for step in mrroc_trace.steps(path)` yields one Step per step of a Move or Wait, in the order of the file.

docs/reference/recording.md describes recordings, src/messages/msg their messages. Units: ticks, rad, m, N, N m. A pose is
(x, y, z, qw, qx, qy, qz), a wrench (fx, fy, fz, tx, ty, tz). A number that is not finite is nan.

`mrroc trace cat` decodes the recording. The program is that of the environment variable MRROC, else build/bin/mrroc of this source tree,
else mrroc of PATH.
"""

import dataclasses
import json
import math
import os
import pathlib
import subprocess
import sys

KINDS = ("query", "hold", "joint", "pose", "motor", "joint_velocity", "twist", "force", "change")  # as numbered in Command.msg
INTERPOLATIONS = ("joints", "motors", "task")
ENDINGS = (None, "condition", "generator", "end_motion", "stopped", "non_fatal_error", "hardware_error", "system_error")
ERRORS = (None, "non-fatal error", "hardware error", "system error")
MODES = ("interactive", "polled", "published")
TARGETS = {"query": 0, "hold": 0, "change": 0, "pose": 7, "twist": 6, "force": 12}  # numbers; the other kinds have one per axis


@dataclasses.dataclass
class Command:
    kind: str
    motion_steps: int  # N
    reply_step: int  # v
    relative: bool = False
    interpolation: str = "joints"  # or motors, task
    start_tick: int | None = None
    target: list[float] = dataclasses.field(default_factory=list)  # joints, motor shafts, a pose, velocities or a twist, as the kind says
    behaviour: str | None = None  # of a force motion: a letter per axis
    wrench: list[float] | None = None  # of a force motion: desired


@dataclasses.dataclass
class Robot:
    tick: int
    macrostep: int
    joints: list[float]
    pose: list[float]
    desired_tick: int
    desired: list[float]
    desired_pose: list[float]
    moving: bool = False
    late: int = 0
    wrench: list[float] | None = None
    lost: float = 0.0
    error: str | None = None
    command: Command | None = None


@dataclasses.dataclass
class Sensor:
    tick: int
    values: list[float]
    period: int = 1
    published: bool = False
    polled: bool = False
    error: str | None = None


@dataclasses.dataclass
class Step:
    tick: int
    process: str
    instruction: int
    step: int
    move: str | None = None  # None: the instruction is a Wait
    until: str | None = None
    wait: str | None = None  # None: the instruction is a Move
    held: int = 0
    robots: dict[str, Robot] = dataclasses.field(default_factory=dict)
    sensors: dict[str, Sensor] = dataclasses.field(default_factory=dict)
    conditions: dict[str, bool] = dataclasses.field(default_factory=dict)
    ending: str | None = None  # None: the instruction continues
    skew: int | None = None


def steps(path):
    """Yields the steps of a recording, or of a file .jsonl with the output of `mrroc trace cat`.

    Raises ValueError with the file and the reason when a message is malformed, and at the end when the program could not read the file.
    """
    for number, line in enumerate(_lines(path), 1):
        try:
            entry = json.loads(line, parse_int=_whole)
            step = _step(entry["message"]) if entry["type"] == "mrroc_msgs/msg/Step" else None
        except KeyError as error:
            raise ValueError(f"{path}: message {number}: the field {error} is missing") from None
        except (TypeError, ValueError) as error:
            raise ValueError(f"{path}: message {number}: {error}") from None
        if step:
            yield step


def _lines(path):
    if str(path).endswith(".jsonl"):
        with open(path, "rb") as file:
            yield from file
        return
    own = pathlib.Path(__file__).resolve().parents[1] / "build/bin/mrroc"
    program = os.environ.get("MRROC") or (own if own.exists() else "mrroc")
    with subprocess.Popen([program, "trace", "cat", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as cat:
        yield from cat.stdout
        report = cat.stderr.read().decode(errors="replace").strip()
    if cat.returncode != 0:
        raise ValueError(f"{path}: {report or f'{program} trace cat: exit code {cat.returncode}'}")
    if report:
        print(report, file=sys.stderr)  # the recording ends early


def _whole(digits):
    return -0.0 if digits == "-0" else int(digits)  # a coordinate may be -0.0


def _word(message, key, words):
    if message[key] not in range(len(words)):
        raise ValueError(f"{key}: {message[key]}, expected 0 to {len(words) - 1}")
    return words[message[key]]


def _numbers(values):
    return [math.nan if value is None else float(value) for value in values]


def _pose(message):
    position, orientation = message["position"], message["orientation"]
    return _numbers([*(position[axis] for axis in "xyz"), *(orientation[axis] for axis in "wxyz")])


def _error(message):
    name = _word(message, "error_class", ERRORS)
    return f"{name}: {message['error']}" if name else None


def _command(message):
    kind, target = _word(message, "kind", KINDS), _numbers(message["target"])
    if len(target) != TARGETS.get(kind, len(target)):
        raise ValueError(f"target of {kind}: {len(target)} numbers, expected {TARGETS[kind]}")
    target, behaviour, wrench = (target[:6], message["behaviour"], target[6:]) if kind == "force" else (target, None, None)
    return Command(kind, message["motion_steps"], message["reply_step"], message["relative"],
                   _word(message, "interpolation", INTERPOLATIONS), message["start_tick"] or None, target, behaviour, wrench)


def _robot(message):
    return Robot(message["tick"], message["macrostep_start"], _numbers(message["joints"]), _pose(message["pose"]), message["desired_tick"],
                 _numbers(message["desired_joints"]), _pose(message["desired_pose"]), message["moving"], message["late_commands"],
                 _numbers(message["wrench"]) or None, *_numbers([message["lost"]]), _error(message),
                 next(map(_command, message["command"]), None))


def _sensor(message):
    mode = _word(message, "mode", MODES)
    return Sensor(message["tick"], _numbers(message["values"]), message["period"], mode == "published", mode == "polled", _error(message))


def _step(message):
    if message["cut"]:
        raise ValueError("the step is cut: it was too long for the recorder")
    return Step(message["tick"], message["process"], message["instruction"], message["step_number"],
                message["name"] if message["is_move"] else None, next(iter(message["until"]), None),
                None if message["is_move"] else message["name"], message["held"],
                {robot["name"]: _robot(robot) for robot in message["robots"]},
                {sensor["name"]: _sensor(sensor) for sensor in message["sensors"]},
                {condition["name"]: condition["holds"] for condition in message["conditions"]},
                _word(message, "ending", ENDINGS), next(iter(message["skew"]), None))
