"""Compares docs/how-to/can.md with the source: the tables that bench/can_load.py prints, the lengths of the PDOs that it assumes,
every key of the table of drives and of [robots.NAME.can], with its default.

Usage: check_can.py SOURCE_DIR
"""

import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True

PAGE = "docs/how-to/can.md"
DEFAULT = re.compile(r"^  [\w:]+ (\w+) = ([\d.]+);", re.MULTILINE)


def only(source):
    """Keys of each `only({...})`."""
    return [re.findall(r'"(\w+)"', keys) for keys in re.findall(r"only\(\{(.*?)\}\)", source, re.DOTALL)]


def pdo_sizes(source):
    """Bytes of RPDO 1 by mode, of TPDO 1 and of TPDO 2."""
    body = re.search(r"^DrivePdos drive_pdos\(.*?^}", source, re.MULTILINE | re.DOTALL).group()
    targets = {mode.lower(): int(size) for mode, size in re.findall(r"\{kTarget(\w+), (\d)\}", body)}
    command, feedback, status = (
        sum(int(size) for size in re.findall(r"\{k\w+, (\d)\}", mapping))
        for mapping in re.findall(r"PdoMapping\(\{(\{.*?\})\}\)", body)
    )
    return {mode: command + size for mode, size in targets.items()}, feedback, status


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    page = (root / PAGE).read_text(encoding="utf-8")
    script = root / "bench/can_load.py"
    problems = []

    printed = subprocess.run([sys.executable, script], capture_output=True, text=True, check=True).stdout
    problems += [f"bench/can_load.py prints a line that is missing on the page: {line}" for line in printed.splitlines() if line not in page.splitlines()]

    sys.path.insert(0, str(script.parent))
    import can_load

    in_script = (can_load.COMMAND, can_load.FEEDBACK, can_load.STATUS)
    in_source = pdo_sizes((root / "drivers/socketcan/drive_setup.cpp").read_text(encoding="utf-8"))
    if in_source != in_script:
        problems.append(f"the PDOs of drivers/socketcan/drive_setup.cpp have {in_source} bytes, those of bench/can_load.py {in_script}")

    load = (root / "src/config/drives/bus_load.cpp").read_text(encoding="utf-8")
    bytes_of = {name: int(size) for name, size in re.findall(r"\bk(\w+) = (\d+)[,;]", load)}
    in_check = ({mode: bytes_of[f"{mode.capitalize()}Command"] for mode in in_script[0]}, bytes_of["Feedback"], bytes_of["Status"])
    if in_check != in_script:
        problems.append(f"src/config/drives/bus_load.cpp has PDOs of {in_check} bytes, bench/can_load.py {in_script}")

    rows = {key: line for line in page.splitlines() if line.startswith("| `") for key in re.findall(r"`(\w+)`", line.split("|")[1])}
    tables = only((root / "src/config/drives/drive_table.cpp").read_text(encoding="utf-8"))
    for file in ("src/config/drives/io_table.cpp", "src/config/entries/can_entry.cpp"):
        tables += only((root / file).read_text(encoding="utf-8"))
    keys = sum(tables, [])
    problems += [f"the key {key} has no row" for key in keys if key not in rows]
    struct = re.search(r"^struct DriveTable \{.*?^\};", (root / "src/config/drives/drive_table.hpp").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    for key, value in DEFAULT.findall(struct.group()):
        if key in rows and not rows[key].rstrip(" |").endswith(f"| {value}"):
            problems.append(f"the default of {key} is {value}: {rows[key]}")

    print("\n".join(f"{PAGE}: {problem}" for problem in problems) or f"{len(keys)} keys, {len(printed.splitlines())} lines of figures")
    return 1 if problems or not keys else 0


if __name__ == "__main__":
    sys.exit(main())
