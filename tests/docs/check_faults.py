"""Compares docs/how-to/fault-injection.md with the source, and runs its commands.

Every action of src/faults/parse_fault.cpp has a row, and every row is an action. The page's commands `mrroc run ... --inject` run in a
scratch folder; `press_io.toml` there is tasks/press/press.toml with the page's section and table. Each ends with the exit code below, and
prints the lines that the page shows, apart from ticks.

Usage: check_faults.py SOURCE_DIR BINARY_DIR
"""

import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True

PAGE = "docs/how-to/fault-injection.md"
ACTIONS = re.compile(r'^    \{"(\w+)", Kind::', re.MULTILINE)
ROW = re.compile(r"^\| (`\w+`(?:, `\w+`)*)(?: by X)? \| [^|]+ \| [^|]+ \|$", re.MULTILINE)
TRANSCRIPT = re.compile(r"^```\n\$ mrroc (run [^\n]*--inject[^\n]*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
TOML = re.compile(r"^```toml\n(.*?)^```", re.MULTILINE | re.DOTALL)
EXIT_CODES = {"kill ecp:arm": 4, "silence io:arm": 3}
TIMEOUT = 120  # s


def without_ticks(line):
    return re.sub(r"tick \d+", "tick N", line)


def write_press_on_a_bus(root, page, folder):
    """press_io.toml and io.toml in `folder`."""
    section, table = TOML.findall(page)
    text = (root / "tasks/press/press.toml").read_text(encoding="utf-8")
    text = text.replace('hardware = "mujoco"', 'hardware = "socketcan"').replace('"press.xml"', f'"{root}/tasks/press/press.xml"')
    (folder / "press_io.toml").write_text(text + "\n" + section, encoding="utf-8")
    (folder / "io.toml").write_text(table, encoding="utf-8")


def run(root, binary, folder, arguments, shown):
    """What a command of the page does otherwise than the page says."""
    words = [str(root / word) if word.startswith("tasks/") else word for word in shlex.split(arguments)]
    fault = words[words.index("--inject") + 1]
    done = subprocess.run([binary / "bin/mrroc", *words], cwd=folder, capture_output=True, text=True, check=False, timeout=TIMEOUT)
    expected = next((code for start, code in EXIT_CODES.items() if fault.startswith(start)), None)
    output = done.stdout + done.stderr
    if done.returncode != expected:
        yield f"mrroc {arguments}: exit code {done.returncode}, expected {expected}\n{output}"
    printed = [without_ticks(line) for line in output.splitlines()]
    yield from (f"mrroc {arguments} does not print: {line}\n{output}" for line in shown.splitlines() if without_ticks(line) not in printed)


def main():
    root, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    page = (root / PAGE).read_text(encoding="utf-8")
    actions = ACTIONS.findall((root / "src/faults/parse_fault.cpp").read_text(encoding="utf-8"))
    rows = [word for cell in ROW.findall(page) for word in re.findall(r"`(\w+)`", cell)]
    problems = [f"the action {action} has no row" for action in actions if action not in rows]
    problems += [f"the row {row} is not an action" for row in rows if row not in actions]
    commands = TRANSCRIPT.findall(page)
    with tempfile.TemporaryDirectory(prefix="mrroc_faults_") as name:
        write_press_on_a_bus(root, page, pathlib.Path(name))
        for arguments, shown in commands:
            problems += run(root, binary, pathlib.Path(name), arguments, shown)
    print("\n".join(f"{PAGE}: {problem}" for problem in problems) or f"{len(actions)} actions, {len(commands)} commands run")
    return 1 if problems or not actions or len(commands) != len(EXIT_CODES) else 0


if __name__ == "__main__":
    sys.exit(main())
