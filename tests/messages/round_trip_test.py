"""Every message, with random values, between our CDR and two independent implementations, rosbags and mcap-ros2-support.

Usage: round_trip_test.py RECODE_MESSAGES MSG_FOLDER
"""

import dataclasses
import pathlib
import random
import re
import struct
import subprocess
import sys

import numpy
from mcap_ros2._dynamic import generate_dynamic
from rosbags.typesys import get_types_from_msg
from rosbags.typesys import store as rosbags_store
from rosbags.typesys.store import Typestore
from rosbags.interfaces import Nodetype

VALUES = 200  # of each message
SEED = 32
# a byte is signed in rosbags, a char in mcap-ros2-support: values that all have
RANGES = {"int8": (-(2**7), 2**7 - 1), "int16": (-(2**15), 2**15 - 1), "int32": (-(2**31), 2**31 - 1),
          "int64": (-(2**63), 2**63 - 1), "uint8": (0, 2**8 - 1), "uint16": (0, 2**16 - 1), "uint32": (0, 2**32 - 1),
          "uint64": (0, 2**64 - 1), "byte": (0, 2**7 - 1), "char": (0, 2**7 - 1)}
SPECIAL = [0.0, -0.0, 1e-308, 5e-324, 1.7976931348623157e308, float("inf"), -float("inf"), 0.1, -1.0]


# a char of ROS 2 is a uint8 (rosidl_adapter), in rosbags a type of its own: the published hash of ROS 2 decides
rosbags_store.TIDMAP["char"] = rosbags_store.TIDMAP["uint8"]
PUBLISHED = {
    "rmw_dds_common/msg/ParticipantEntitiesInfo": "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e",
    "action_msgs/msg/GoalStatusArray": "RIHS01_6c1684b00f177d37438febe6e709fc4e2b0d4248dca4854946f9ed8b30cda83e",
    "control_msgs/action/FollowJointTrajectory_FeedbackMessage": "RIHS01_80398fcb9674a79081a9906e2ccf0c804dd7cb15e22e362e606ee87186beab71",
}
RELEASE = re.compile(r"^(\w+)_(humble|kilted)/")


def number(name, draw):
    if name == "bool":
        return draw.random() < 0.5
    if name == "float64":
        return draw.choice([draw.choice(SPECIAL), draw.gauss(0, 1)])
    if name == "float32":
        return struct.unpack("<f", struct.pack("<f", draw.gauss(0, 1)))[0]
    low, high = RANGES[name]
    return draw.choice([low, high, draw.randint(low, high)])


def text(draw):
    return "".join(draw.choice("abcXYZ019 _/\"\\\näßλ🤖") for _ in range(draw.choice([0, 1, 3, 17])))


def value_of(store, description, draw):
    kind, argument = description
    if kind == Nodetype.BASE:
        return text(draw)[:argument[1] or None] if argument[0] == "string" else number(argument[0], draw)
    if kind == Nodetype.NAME:
        return message_of(store, argument, draw)
    inner, bound = argument
    count = bound if kind == Nodetype.ARRAY else draw.randint(0, bound or 5)
    values = [value_of(store, inner, draw) for _ in range(count)]
    if inner[0] == Nodetype.BASE and inner[1][0] != "string":
        return numpy.array(values, dtype={"char": "uint8"}.get(inner[1][0], inner[1][0]))
    return values


def message_of(store, name, draw):
    fields = store.fielddefs[name][1]
    return store.types[name](**{field: value_of(store, inner, draw) for field, inner in fields})


def plain(value):
    """Of either implementation: the values as dictionaries and lists; floating-point numbers by their bits."""
    if isinstance(value, numpy.ndarray):
        value = value.tolist()
    if isinstance(value, (bytes, bytearray, list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, float):
        return struct.pack("<d", value)
    if isinstance(value, (bool, int, str)):
        return value
    if dataclasses.is_dataclass(value):  # of rosbags, which makes the constants fields, too
        names = [field.name for field in dataclasses.fields(value) if field.name.islower() and field.name[0] != "_"]
    else:
        names = value.__slots__
    return {name: plain(getattr(value, name)) for name in names}


def hash_of(store, name, definitions):
    """Of a package of one release: that of the type with the package's own name, as this release has it."""
    if not (release := RELEASE.match(name)):
        return PUBLISHED.get(name, store.hash_rihs01(name))
    alone = Typestore()
    alone.register({key: fields for key, (fields, _) in definitions.items() if not RELEASE.match(key) and not key.startswith(f"{release[1]}/")})
    texts = {RELEASE.sub(r"\1/", key): text for key, (_, text) in definitions.items() if key.startswith(release[0])}
    for key, text in texts.items():
        alone.register(get_types_from_msg(text, key))
    return alone.hash_rihs01(RELEASE.sub(r"\1/", name))


def for_mcap(text):
    """Without the names of an action's parts, which mcap-ros2-support does not have."""
    return re.sub(r"(FollowJointTrajectory)_", r"\1", text.replace("/action/", "/"))


class Recoder:
    def __init__(self, program):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def ask(self, line):
        self.process.stdin.write(line.encode() + b"\n")
        self.process.stdin.flush()
        return self.process.stdout.readline().decode().rstrip("\n")

    def recode(self, name, data):
        return self.ask(f"{name} {bytes(data).hex()}")

    def describe(self, name):
        type_hash, size = self.ask(name).split()
        schema = self.process.stdout.read(int(size)).decode()
        assert self.process.stdout.readline() == b"\n", name
        return type_hash, schema


def main():
    program, folder = sys.argv[1:]
    names = {"/".join((*file.parts[-3:-1], file.stem)): file.read_text(encoding="utf-8") for file in sorted(pathlib.Path(folder).glob("*/*/*.msg"))}
    definitions = {name: (get_types_from_msg(text, name)[name], text) for name, text in names.items()}
    store = Typestore()
    store.register({name: fields for name, (fields, _) in definitions.items()})
    recoder = Recoder(program)
    draw = random.Random(SEED)
    cut = 0
    for name in names:
        type_hash, schema = recoder.describe(name)
        assert type_hash == hash_of(store, name, definitions), name
        # the schema text alone describes the message, for both
        alone = Typestore()
        alone.register(get_types_from_msg(schema, name))
        assert alone.fielddefs[name] == store.fielddefs[name], name
        decode = generate_dynamic(for_mcap(name), for_mcap(schema))[for_mcap(name)]
        for _ in range(VALUES):
            message = message_of(store, name, draw)
            expected = bytes(store.serialize_cdr(message, name, little_endian=True))
            swapped = bytes(store.serialize_cdr(message, name, little_endian=False))
            for data in (expected, swapped):
                found = recoder.recode(name, data)
                assert not found.startswith("error"), f"{name}: {found}\n{data.hex()}"
                ours = bytes.fromhex(found)
                # the padding at the end is left to the writer
                assert ours.rstrip(b"\0") == expected.rstrip(b"\0") and abs(len(ours) - len(expected)) < 4, (
                    f"{name}:\n{found}\n{expected.hex()}")
            assert plain(store.deserialize_cdr(ours, name)) == plain(message), name
            other = plain(decode(ours))
            assert other == plain(message), f"{name}:\n{other}\n{plain(message)}"
            # no prefix is a message, but one that only lacks padding
            length = draw.randrange(0, len(ours))
            found = recoder.recode(name, ours[:length])
            cut += 1
            assert found.startswith("error: CDR"), f"{name}: {length} of {len(ours)} bytes are accepted"
            assert recoder.recode(name, ours + b"\0\0\0\0").startswith("error: CDR: 4 bytes follow"), name
    print(f"{len(names)} messages, {VALUES} values of each in both byte orders, {cut} cut short and refused")


if __name__ == "__main__":
    main()
