"""Reads the trace of a run: `for step in mrroc_trace.steps(path)` yields one Step per line, in the order of the file.

docs/reference/trace.md describes the fields. Units: ticks, rad, m, N, N m. A pose is (x, y, z, qw, qx, qy, qz), a wrench (fx, fy, fz, tx, ty, tz).
"""

import dataclasses
import re

LONGEST = 16384  # bytes; the writer cuts a longer line
SHOWN = 60  # characters of a text in a message
ENDINGS = ("condition", "generator", "end_motion", "stopped", "non_fatal_error", "hardware_error", "system_error")
TARGETS = {"pose": 7, "twist": 6, "force": 6}  # numbers of the target by kind of command; the other targets have one per axis


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
    """Yields the steps of a trace. Raises ValueError with the file, the line number, the invalid text and what was expected."""
    with open(path, "rb") as trace:
        for number, line in enumerate(trace, 1):
            if line.startswith(b"#"):
                continue
            try:
                step = _step(line)
            except ValueError as error:
                raise ValueError(f"{path}:{number}: {error}") from None
            yield step


def _malformed(text, expected):
    return ValueError(f"'{text[:SHOWN]}', expected {expected}")


def _count(text):
    if not (text.isascii() and text.isdigit()):
        raise _malformed(text, "a whole number")
    return int(text)


def _numbers(text, size=None):
    try:
        numbers = [float(value) for value in text.split(",")] if text else []
    except ValueError:
        raise _malformed(text, "numbers separated by commas") from None
    if size not in (None, len(numbers)):
        raise _malformed(text, f"{size} numbers")
    return numbers


def _ending(text):
    if text not in ENDINGS:
        raise _malformed(text, f"one of {', '.join(ENDINGS)}")
    return text


def _command(text):
    fields, _ = _take(COMMAND, text)
    command = Command(**fields)
    if len(command.target) != TARGETS.get(command.kind, len(command.target)):
        raise _malformed(text, f"{TARGETS[command.kind]} numbers as the target")
    if (command.kind == "force") != (command.behaviour is not None):
        raise _malformed(text, "a letter per axis and a wrench after the target of force, and of no other kind")
    return command


def _take(pattern, text):
    """The fields of a part of a line by their keys, without those that are missing, and the text after the part."""
    found = pattern.match(text)
    if not found:
        raise _malformed(text, "the fields " + ", ".join(pattern.groupindex) + ", in this order")
    fields = {}
    for key, value in found.groupdict().items():
        try:
            if value is not None:
                fields[key] = READERS.get(key, str)(value)
        except ValueError as error:
            raise ValueError(f"{key}: {error}") from None
    return fields, text[found.end():]


def _step(line):
    if len(line) > LONGEST or not line.endswith(b"\n"):
        raise _malformed(line[-SHOWN:].decode(errors="replace"), f"a whole line, of less than {LONGEST} characters: this line is cut")
    fields, rest = _take(STEP, line.decode().rstrip("\n"))
    step = Step(**fields)
    for key, pattern, kind, parts in (("robot", ROBOT, Robot, step.robots), ("sensor", SENSOR, Sensor, step.sensors)):
        while rest.startswith(f" {key}="):
            fields, rest = _take(pattern, rest)
            name = fields.pop(key)
            parts[name] = kind(**fields)
    while rest.startswith(" condition="):
        fields, rest = _take(CONDITION, rest)
        step.conditions[fields["condition"]] = fields["value"] == "1"
    fields, rest = _take(END, rest)
    if rest:
        raise _malformed(rest, "a field of the trace or the end of the line")
    return dataclasses.replace(step, **fields)


def _pattern(text):
    """Of a part of a line: KEY=_ stands for a field without spaces, KEY="_" for a text in quotes."""
    return re.compile(re.sub(r'(\w+)="_"', r'\1="(?P<\1>.*?)"', re.sub(r"(\w+)=_", r"\1=(?P<\1>\\S*)", text)), re.ASCII)


STEP = _pattern('tick=_ process=_ instruction=_ (?:move="_"(?: until="_")?|wait="_") step=_(?: held=_)?')
ROBOT = _pattern(" robot=_ tick=_ macrostep=_ joints=_ pose=_ desired_tick=_ desired=_ desired_pose=_(?P<moving> moving)?(?: late=_)?"
                 '(?: wrench=_)?(?: lost=_)?(?: error="_")?(?: command=_)?')
COMMAND = re.compile(r"(?P<kind>(?:query|hold|change)(?!.*:)|(?:joint|pose|motor|joint_velocity|twist|force)(?=,.*:))(?P<relative>,relative)?"
                     r"(?:,(?P<interpolation>motors|task))?,N(?P<motion_steps>\d+),v(?P<reply_step>\d+)(?:,start(?P<start_tick>\d+))?"
                     r"(?::(?P<target>.+?)(?:,(?P<behaviour>[ugc?]{6}),(?P<wrench>.+))?)?$")
SENSOR = _pattern(' sensor=_ tick=_ values=_(?: period=_)?(?P<published> published)?(?P<polled> polled)?(?: error="_")?')
CONDITION = _pattern(' condition="_":(?P<value>[01])')
END = _pattern(r"(?: end=(?P<ending>\S+))?(?: skew=_)?")
READERS = {
    **dict.fromkeys(("tick", "instruction", "step", "held", "macrostep", "desired_tick", "late", "period", "skew"), _count),
    **dict.fromkeys(("motion_steps", "reply_step", "start_tick"), _count),
    **dict.fromkeys(("joints", "desired", "values", "target"), _numbers),
    **dict.fromkeys(("pose", "desired_pose"), lambda text: _numbers(text, 7)),
    **dict.fromkeys(("moving", "published", "polled", "relative"), bool),
    "wrench": lambda text: _numbers(text, 6),
    "lost": lambda text: _numbers(text, 1)[0],
    "ending": _ending,
    "command": _command,
}
