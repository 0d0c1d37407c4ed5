"""Follows a tutorial: writes its files into an empty folder, runs its commands, and compares what they print.

A line `...` in an expected output stands for any lines, `...` within a line for any words. A command with `--hold` is
that of a first terminal: its run continues beside the next commands, and must end with them, stopped by the operator. An
order that comes while a robot is busy, faster than a reader types, is given again. The tutorial's example has the same
files, and those that the page links, which the reader downloads. The folder is also the reader's home.

Usage: check_tutorial.py SOURCE_DIR BINARY_DIR PAGE [EXAMPLE] [-Dcache=entry ...]
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

TIMEOUT = 120  # s of a busy machine
BUSY = "the receiver is busy: "
STOPPED = 5  # exit code of a run that the operator has stopped


def files_of(text):
    return re.findall(r"^`([\w./]+)`:\n\n```\w+\n(.*?)^```", text, re.M | re.S)


def commands_of(text):
    """(command, expected output) of every console block."""
    for block in re.findall(r"^```console\n(.*?)^```", text, re.M | re.S):
        for command, output in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, re.M):
            yield command, output


def matches(expected, printed):
    within = re.escape("...")
    pattern = "".join(".*" if line == "..." else re.escape(line).replace(within, r"[^\n]*") + r"\n" for line in expected.splitlines())
    return re.fullmatch(pattern, printed, re.S) is not None


def run(command, scratch, environment):
    """The command, again while it is refused because a robot is busy: with its drives, or with the order before."""
    deadline = time.monotonic() + TIMEOUT
    while True:
        done = subprocess.run(command, shell=True, cwd=scratch, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode == 0 or BUSY not in done.stdout or time.monotonic() > deadline:
            return done
        time.sleep(0.1)


def held_run(command, scratch, environment):
    """The process of a run with --hold, when it is held."""
    held = subprocess.Popen(["bash", "-c", f"exec {command}"], cwd=scratch, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, text=True)
    deadline = time.monotonic() + TIMEOUT
    while held.poll() is None and time.monotonic() < deadline:
        status = subprocess.run(["mrroc", "status", "--json"], env=environment, capture_output=True, text=True, check=False)
        if status.returncode == 0 and json.loads(status.stdout)["task"] == "held":
            break
        time.sleep(0.1)
    return held


def end_of(held):
    """Exit code and output of a held run, which the commands have ended; killed if they have not."""
    try:
        output, _ = held.communicate(timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        held.kill()
        output, _ = held.communicate()
    return held.returncode, output


def main():
    source, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    text = (source / "docs/tutorials" / sys.argv[3]).read_text(encoding="utf-8")
    example = source / "docs/examples" / next((name for name in sys.argv[4:5] if not name.startswith("-D")), "none")
    examples = sorted(path for path in example.rglob("*") if path.is_file())
    files = files_of(text) + [(path.name, path.read_text(encoding="utf-8")) for path in examples
                              if f"](../examples/{example.name}/{path.name})" in text]
    problems = []
    for name, content in files:
        if not (example / name).is_file() or (example / name).read_text(encoding="utf-8") != content:
            problems.append(f"{example}/{name} differs from the tutorial's")
    problems += [f"{path} is not in the tutorial" for path in examples
                 if path.relative_to(example).as_posix() not in dict(files)]
    environment = {name: value for name, value in os.environ.items() if not name.startswith("MRROC_")}
    environment["mrroc"] = str(binary)
    environment["PATH"] = f"{binary}/bin:{environment['PATH']}"
    environment.pop("XDG_DATA_HOME", None)
    ran = 0
    with tempfile.TemporaryDirectory(prefix="mrroc_tutorial_") as scratch:
        environment["HOME"] = scratch
        environment["MRROC_RUNTIME_DIR"] = f"{scratch}/.run"
        held = None
        for name, content in files:
            path = pathlib.Path(scratch) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
        for command, expected in commands_of(text):
            if problems:
                break
            ran += 1
            if "--hold" in command:
                held = held_run(command, scratch, environment)
                continue
            options = " ".join(sys.argv[5:]) if command.startswith("cmake -B") else ""
            done = run(f"{command} {options}", scratch, environment)
            if done.returncode != 0 or not matches(expected, done.stdout):
                problems.append(f"$ {command}\nexit code {done.returncode}, printed:\n{done.stdout}expected:\n{expected}")
        if held:
            if problems:
                held.kill()
            code, output = end_of(held)
            if code != STOPPED:
                problems.append(f"the held run: exit code {code}, expected {STOPPED}, printed:\n{output}")
    print("\n".join(problems) or f"{len(files)} files, {ran} commands")
    return 1 if problems or ran < 5 else 0


if __name__ == "__main__":
    sys.exit(main())
