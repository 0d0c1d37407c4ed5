#!/usr/bin/env python3
"""Makes C++ sources and IDL from ROS 2 message descriptions: FOLDER/PACKAGE/msg/Name.msg, and of actions
FOLDER/PACKAGE/action/Action_Part.msg. A package of which a release of ROS 2 has other fields has that release in its
name, PACKAGE_humble or PACKAGE_kilted: the name of its types on DDS and their hashes are those of PACKAGE.

Usage: generate.py FOLDER --outputs        the names of the sources that it makes, one a line
       generate.py FOLDER INTO             writes them, and INTO/idl/PACKAGE/msg/Name.idl

Of each message: a struct in mrroc::messages::PACKAGE, its CDR encoder and decoder, its text as JSON, and the text of its schema (ros2msg:
the description, then those of the messages that it contains) and its type hash. Not supported, and refused: wstring, arrays of
bounded strings, default values, sequences of booleans, messages without fields, messages that contain themselves.
"""

import pathlib
import re
import sys

sys.dont_write_bytecode = True  # a build leaves the sources as they are
from idl import idl_of  # noqa: E402
from type_hash import type_hash  # noqa: E402

PRIMITIVES = {  # name: C++, bytes
    "bool": ("bool", 1),
    "byte": ("std::uint8_t", 1),
    "char": ("std::uint8_t", 1),
    "int8": ("std::int8_t", 1),
    "uint8": ("std::uint8_t", 1),
    "int16": ("std::int16_t", 2),
    "uint16": ("std::uint16_t", 2),
    "int32": ("std::int32_t", 4),
    "uint32": ("std::uint32_t", 4),
    "int64": ("std::int64_t", 8),
    "uint64": ("std::uint64_t", 8),
    "float32": ("float", 4),
    "float64": ("double", 8),
    "string": ("std::string", 4),  # at least its length
}
FIELD = re.compile(r"^(?P<type>[A-Za-z0-9_/]+)(?:<=(?P<text_bound>[1-9]\d*))?(?:\[(?P<bound><=)?(?P<size>\d*)\])?\s+(?P<name>[a-z][a-z0-9_]*)$")
NAME = {"msg": re.compile(r"[A-Z][A-Za-z0-9]*"), "action": re.compile(r"[A-Z][A-Za-z0-9]*_[A-Z][A-Za-z0-9]*")}
RELEASE = re.compile(r"_(humble|kilted)$")
CONSTANT = re.compile(r"^(?P<type>[a-z0-9]+)\s+(?P<name>[A-Z][A-Z0-9_]*)\s*=\s*(?P<value>.+)$")


class Field:
    def __init__(self, kind, name, size, bounded, array, text_bound):
        self.kind, self.name, self.size, self.bounded, self.array = kind, name, size, bounded, array
        self.text_bound = text_bound
        self.message = None  # of the type, when that is no primitive


class Message:
    def __init__(self, package, folder, name, text):
        self.package, self.folder, self.name, self.text = package, folder, name, text
        self.cpp_name = name.replace("_", "")
        self.fields, self.constants = [], []

    @property
    def key(self):
        return f"{self.package}/{self.name}"

    @property
    def path(self):
        """Of its description; also its name in the table of all messages."""
        return f"{self.package}/{self.folder}/{self.name}"

    @property
    def ros_type(self):
        return f"{RELEASE.sub('', self.package)}/{self.folder}/{self.name}"

    @property
    def schema_name(self):
        return self.key if self.folder == "msg" else self.path

    @property
    def stem(self):
        return f"{self.package}/{re.sub(r'(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])', '_', self.cpp_name).lower()}"


def fail(file, number, problem):
    sys.exit(f"{file}:{number}: {problem}")


def read(file):
    package, folder, name = file.parts[-3], file.parts[-2], file.stem
    message = Message(package, folder, name, file.read_text(encoding="utf-8"))
    if not NAME[folder].fullmatch(name):
        fail(file, 0, f"name {name}, expected {'CamelCase' if folder == 'msg' else 'Action_Part'}")
    for number, line in enumerate(message.text.splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        if match := CONSTANT.match(line):
            if match["type"] not in PRIMITIVES:
                fail(file, number, f"type '{match['type']}' of a constant, expected one of {', '.join(PRIMITIVES)}")
            message.constants.append((match["type"], match["name"], match["value"].strip()))
            continue
        match = FIELD.match(line)
        if not match:
            fail(file, number, f"'{line}', expected TYPE NAME, TYPE[] NAME, TYPE[N] NAME, TYPE[<=N] NAME or TYPE NAME=VALUE")
        kind = re.sub("/(msg|action)/", "/", match["type"])
        if kind not in PRIMITIVES and "/" not in kind:
            kind = f"{package}/{kind}"
        if match["text_bound"] and (kind != "string" or "[" in line):
            fail(file, number, f"'{line}', expected string<=N NAME or no bound")
        if match["bound"] and not match["size"]:
            fail(file, number, f"'{line}', expected a number behind <=")
        size = int(match["size"]) if match["size"] else None
        if kind == "bool" and "[" in line and (size is None or match["bound"]):
            fail(file, number, f"'{line}' is a sequence of booleans, expected uint8")
        if size == 0:
            fail(file, number, f"'{line}', expected a size of at least 1")
        text_bound = int(match["text_bound"]) if match["text_bound"] else None
        message.fields.append(Field(kind, match["name"], size, bool(match["bound"]), match["size"] is not None, text_bound))
    if not message.fields:
        fail(file, 0, "no field, expected at least one")
    return message


def read_all(folder):
    """The messages by name, each below those that it contains."""
    files = {f"{file.parts[-3]}/{file.stem}": file for file in sorted([*folder.glob("*/msg/*.msg"), *folder.glob("*/action/*.msg")])}
    if not files:
        sys.exit(f"{folder}: no PACKAGE/msg/NAME.msg")
    messages, order = {key: read(file) for key, file in files.items()}, {}

    def add(key, above):
        if key in above:
            fail(files[key], 0, "contains itself: " + " > ".join([*above, key]))
        if key in order:
            return
        for field in messages[key].fields:
            if field.kind in PRIMITIVES:
                continue
            if field.kind not in messages:
                fail(files[key], 0, f"type '{field.kind}' of {field.name} has no file in {folder}")
            field.message = messages[field.kind]
            add(field.kind, [*above, key])
        order[key] = messages[key]

    for key in messages:
        add(key, [])
    return order


def contained(message, messages, found=None):
    """The messages in it, each once, in the order of their first appearance."""
    found = {} if found is None else found
    for field in message.fields:
        if field.kind not in PRIMITIVES and field.kind not in found:
            found[field.kind] = messages[field.kind]
            contained(messages[field.kind], messages, found)
    return found


def schema_of(message, messages):
    parts = [message.text]
    for inner in contained(message, messages).values():
        parts.append("=" * 80 + f"\nMSG: {inner.schema_name}\n" + inner.text)
    return "".join(parts)


def smallest(kind, messages):
    """Bytes of its encoding at least, without alignment."""
    if kind in PRIMITIVES:
        return PRIMITIVES[kind][1]
    total = 0
    for field in messages[kind].fields:
        one = smallest(field.kind, messages)
        total += 4 if field.array and (field.bounded or field.size is None) else one * (field.size or 1)
    return total


def cpp_type(field):
    kind = f"{field.message.package}::{field.message.cpp_name}" if field.message else PRIMITIVES[field.kind][0]
    if not field.array:
        return kind
    if field.size is not None and not field.bounded:
        return f"std::array<{kind}, {field.size}>"
    return f"std::vector<{kind}>"


def cpp_constant(kind, name, value):
    if kind == "string":
        return f"  static constexpr std::string_view {name} = {value};"
    if kind == "bool":
        return f"  static constexpr bool {name} = {value.lower()};"
    return f"  static constexpr {PRIMITIVES[kind][0]} {name} = {value};"


def header_of(message, messages):
    includes = sorted({messages[field.kind].stem for field in message.fields if field.kind not in PRIMITIVES})
    lines = ["// Made by src/messages/generate.py", "#pragma once", "", "#include <array>", "#include <cstddef>",
             "#include <cstdint>", "#include <string>", "#include <string_view>", "#include <vector>", "",
             '#include "messages/cdr_reader.hpp"', '#include "messages/cdr_writer.hpp"',
             '#include "messages/json_text.hpp"']
    lines += [f'#include "messages/{stem}.hpp"' for stem in includes]
    lines += ["", f"namespace mrroc::messages::{message.package} {{", "", f"struct {message.cpp_name} {{"]
    lines.append(f'  static constexpr std::string_view kType = "{message.ros_type}";')
    lines.append(f'  static constexpr std::string_view kHash = "{type_hash(message, contained(message, messages).values())}";')
    lines.append(f"  static constexpr std::size_t kSmallest = {smallest(message.key, messages)};  ///< bytes of an encoding, at least")
    lines.append("  static std::string_view schema() noexcept;  ///< ros2msg")
    lines += [cpp_constant(*constant) for constant in message.constants]
    lines.append("")
    for field in message.fields:
        initial = "" if field.array and not (field.size is not None and not field.bounded) else "{}"
        lines.append(f"  {cpp_type(field)} {field.name}{initial};")
    lines += ["", f"  bool operator==(const {message.cpp_name}&) const = default;", "};", "",
              f"void encode(CdrWriter& writer, const {message.cpp_name}& message);",
              "/// Throws CdrError.",
              f"void decode(CdrReader& reader, {message.cpp_name}& message);",
              f"void append_json(std::string& text, const {message.cpp_name}& message);", "",
              f"}}  // namespace mrroc::messages::{message.package}", ""]
    return "\n".join(lines)


def json_of(field, first):
    key = f'{{"{field.name}":' if first else f',"{field.name}":'
    verb = "append_json_list" if field.array else "append_json"
    return f"  text += R\"({key})\";\n  {verb}(text, message.{field.name});"


def code_of(field, verb, stream):
    access = f"message.{field.name}"
    if field.text_bound:
        return f"  {verb}_text({stream}, {access}, {field.text_bound});"
    if not field.array:
        return f"  {verb}({stream}, {access});"
    if field.size is not None and not field.bounded:
        return f"  {verb}_array({stream}, {access});"
    bound = f", {field.size}" if field.bounded else ""
    return f"  {verb}_sequence({stream}, {access}{bound});"


def source_of(message, messages):
    lines = ["// Made by src/messages/generate.py", f'#include "messages/{message.stem}.hpp"', "",
             f"namespace mrroc::messages::{message.package} {{", "",
             f"std::string_view {message.cpp_name}::schema() noexcept {{",
             f'  return R"MSG({schema_of(message, messages)})MSG";', "}", "",
             f"void encode(CdrWriter& writer, const {message.cpp_name}& message) {{"]
    lines += [code_of(field, "encode", "writer") for field in message.fields]
    lines += ["}", "", f"void decode(CdrReader& reader, {message.cpp_name}& message) {{"]
    lines += [code_of(field, "decode", "reader") for field in message.fields]
    lines += ["}", "", f"void append_json(std::string& text, const {message.cpp_name}& message) {{",
              "  using messages::append_json;  // of numbers and texts"]
    lines += [json_of(field, field is message.fields[0]) for field in message.fields]
    lines += ["  text += '}';", "}", "", f"}}  // namespace mrroc::messages::{message.package}", ""]
    return "\n".join(lines)


def table_of(messages):
    lines = ["// Made by src/messages/generate.py", '#include "messages/message_table.hpp"', ""]
    lines += [f'#include "messages/{message.stem}.hpp"' for message in messages.values()]
    lines += ["#include <array>", "", "namespace mrroc::messages {", "", "namespace {", "",
              "template <class Message>", "std::vector<std::byte> recode(std::span<const std::byte> bytes) {",
              "  return to_cdr(from_cdr<Message>(bytes));", "}", "",
              "template <class Message>", "std::string json(std::span<const std::byte> bytes) {",
              "  std::string text;", "  append_json(text, from_cdr<Message>(bytes));", "  return text;", "}", "",
              f"constexpr std::array<MessageType, {len(messages)}> kTypes{{{{"]
    for message in messages.values():
        name = f"{message.package}::{message.cpp_name}"
        lines.append(f'    {{"{message.path}", {name}::kHash, &{name}::schema, &recode<{name}>, &json<{name}>}},')
    lines += ["}};", "", "}  // namespace", "",
              "std::span<const MessageType> message_types() noexcept { return kTypes; }", "",
              "}  // namespace mrroc::messages", ""]
    return "\n".join(lines)


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: generate.py FOLDER --outputs | generate.py FOLDER INTO")
    messages = read_all(pathlib.Path(sys.argv[1]))
    if sys.argv[2] == "--outputs":
        print("\n".join([f"messages/{message.stem}.cpp" for message in messages.values()] + ["messages/message_table.cpp"]))
        return
    into = pathlib.Path(sys.argv[2])
    for message in messages.values():
        write(into / "messages" / f"{message.stem}.hpp", header_of(message, messages))
        write(into / "messages" / f"{message.stem}.cpp", source_of(message, messages))
        write(into / "idl" / f"{message.path}.idl", idl_of(message))
    write(into / "messages" / "message_table.cpp", table_of(messages))


if __name__ == "__main__":
    main()
