"""Checks docs/layouts: what they draw is in a recording of the task press.

Usage: check_layouts.py SOURCE_DIR BINARY_DIR
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

JOINT_VALUE = re.compile(r"(/[^/]+/joint_states)/([^/]+)/(position|velocity|effort)")  # PlotJuggler's name of one joint


def of_foxglove(file):
    """Topic and field of each path of a plot."""
    for panel in json.loads(file.read_text(encoding="utf-8"))["configById"].values():
        for path in panel.get("paths", []):
            yield path["value"].replace("[:]", "").replace(".", "/", 1)


def of_plotjuggler(file, topics):
    for curve in xml.etree.ElementTree.parse(file).getroot().iter("curve"):
        name = re.sub(r"\[\d+\]$", "", curve.get("name"))
        if match := JOINT_VALUE.fullmatch(name):
            yield f"{match[1]}/{match[3]}"
            continue
        topic = next((topic for topic in topics if name.startswith(topic + "/")), "")
        yield topic + "/" + name[len(topic) + 1:].replace("/", ".")


def of_rerun(file):
    """The topic of each plot of one message, and its fields."""
    for topic, fields in re.findall(r'f"/\{\w+\}/(\w+)", \w+, \[([^\n]*)\]\)', file.read_text(encoding="utf-8")):
        for field in re.findall(r'"\.([\w.]+)(?:\[\])?"', fields):
            yield topic, field


def main():
    source, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    with tempfile.TemporaryDirectory() as folder:
        recording = pathlib.Path(folder) / "press.mcap"
        mrroc = [binary / "bin/mrroc"]
        subprocess.run([*mrroc, "run", source / "tasks/press/press.toml", "--quiet", "--clock", "lockstep", "--black-box=", "--record", recording,
                        "--record-rate", "servo"], check=True, cwd=folder)
        listed = subprocess.run([*mrroc, "trace", "plot", recording], check=True, capture_output=True, text=True).stdout.split()
    signals = {line for line in listed if line.startswith("/")}
    topics = {"/arm/joint_states", "/arm/servo", "/wrist/wrench"}
    layouts = source / "docs/layouts"
    drawn = [*of_foxglove(layouts / "foxglove.json"), *of_plotjuggler(layouts / "plotjuggler.xml", topics)]
    problems = [name for name in drawn if name not in signals]
    in_rerun = list(of_rerun(layouts / "rerun_layout.py"))
    problems += [f"{topic}: {field}" for topic, field in in_rerun if not any(name.endswith(f"/{topic}/{field}") for name in signals)]
    print("\n".join(f"no signal {problem}" for problem in problems) or f"{len(drawn) + len(in_rerun)} signals of layouts are in a recording")
    return 1 if problems or len(drawn) < 15 or len(in_rerun) < 4 else 0


if __name__ == "__main__":
    sys.exit(main())
