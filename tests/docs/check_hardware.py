"""Checks the table of docs/reference/on-hardware.md: each task's deployment, with its drives on CAN buses, its terminals
on the I/O nodes of its TASK_io.toml, its force sensors on Net F/Ts and its cameras real, is accepted by `mrroc run --check`
where the page says so, and refused elsewhere, for the named device.

Usage: check_hardware.py SOURCE_DIR BINARY_DIR
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib


def on_hardware(deployment, folder):
    """The deployment on real devices, as far as there are drivers."""
    deployment["deployment"]["clock"] = "real"
    for number, robot in enumerate(deployment.get("robots", {}).values()):
        for key in ("can", "emergency_stop"):
            robot.pop(key, None)
        robot.update(hardware="socketcan", can={"interface": f"can{number}"})
        if (terminals := folder / f"{folder.name}_io.toml").exists():
            robot["can"]["io"] = str(terminals)
    for sensor in deployment.get("sensors", {}).values():
        if sensor["type"] == "force_torque" and sensor.get("source") != "replay":
            sensor.update(source="netft", netft={"address": "192.168.1.1"})
        if sensor["type"] == "camera":
            sensor["source"] = "hardware"
        if "replay" in sensor:
            sensor["replay"] = str(folder / sensor["replay"])
    deployment.pop("sim", None)
    deployment.pop("events", None)
    return deployment


def toml(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(each)}" for key, each in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def text(deployment):
    lines = []
    for part, table in deployment.items():
        if part in ("robots", "sensors"):
            lines += [line for name, device in table.items() for line in (f"[{part}.{name}]", *(f"{key} = {toml(value)}" for key, value in device.items()))]
        elif isinstance(table, list):
            lines += [line for entry in table for line in (f"[[{part}]]", *(f"{key} = {toml(value)}" for key, value in entry.items()))]
        else:
            lines += [f"[{part}]", *(f"{key} = {toml(value)}" for key, value in table.items())]
    return "\n".join(lines) + "\n"


def main():
    root, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    page = (root / "docs/reference/on-hardware.md").read_text(encoding="utf-8")
    rows = {name: (now == "yes", missing) for name, now, missing in re.findall(r"^\| `(\w+)` \|[^|]*\| (yes|no) \| ?([^|]*?) ?\|$", page, re.M)}
    problems, accepted = [], 0
    with tempfile.TemporaryDirectory(prefix="mrroc_hardware_") as scratch:
        for file in sorted(root.glob("tasks/*/*.toml")):
            content = tomllib.loads(file.read_text(encoding="utf-8"))
            if "deployment" not in content:
                continue
            copy = pathlib.Path(scratch) / file.name
            content = on_hardware(content, file.parent)
            if "states" in content.get("mp", {}):
                content["mp"]["states"] = str(file.parent / content["mp"]["states"])
            copy.write_text(text(content), encoding="utf-8")
            done = subprocess.run([binary / "bin/mrroc", "run", copy, "--check"], capture_output=True, text=True, check=False)
            said, missing = rows.pop(file.stem, (None, ""))
            if said is None:
                problems.append(f"{file.stem}: not on the page")
            elif said != (done.returncode == 0) and not (missing and done.returncode == 0):
                problems.append(f"{file.stem}: the page says {'yes' if said else 'no'}\n{done.stderr}")
            elif done.returncode != 0 and not any(word in missing for word in re.findall(r"(?:sensors|robots)\.(\w+)", done.stderr)):
                problems.append(f"{file.stem}: refused for another reason than '{missing}'\n{done.stderr}")
            accepted += bool(said)
    problems += [f"{name}: no such deployment" for name in rows]
    if f"{accepted} of the " not in page:
        problems.append(f"the page does not say '{accepted} of the'")
    print("\n".join(problems) or f"{accepted} deployments run on hardware")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
