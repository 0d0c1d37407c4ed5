"""Checks the transcript in docs/how-to/operate.md: its commands are typed into two terminals of tmux, and what they show is
what the page shows, but for numbers.

check_transcript.py SOURCE_DIR BINARY_DIR [--write]: --write puts the transcript into the page.
"""

import difflib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

PAGE = "docs/how-to/operate.md"
BEGIN, END = "<!-- transcript -->\n", "<!-- end -->"
SHELL = "bash --norc --noprofile"
TIMEOUT = 120  # s of a busy machine
# the task lasts longer than the slowest machine needs for the session; the page shows a run at the programmed speed
SLOW = '[[events]]\ntick = 1\ncommand = "speed"\nvalue = 1\n'
# what is typed, and the state in which the run must be before the next line
SESSION = (
    ("mrroc list", None),
    ("mrroc start press", "running"),
    ("mrroc pause press", "paused"),
    ("mrroc status press", None),
    ("mrroc pause press", None),
    ("mrroc jog arm columm 0.1", None),
    ("mrroc resume press", "running"),
    ("mrroc stop press", None),
)


class Tmux:
    """A server of its own with two terminals: the run's and another."""

    def __init__(self, folder, environment):
        self.socket = f"{folder}/tmux"
        self.environment = environment
        self("new-session", "-d", "-s", "run", "-x", "110", "-y", "40", SHELL)
        self("new-session", "-d", "-s", "operator", "-x", "110", "-y", "60", SHELL)
        for terminal in ("run", "operator"):
            self.type(terminal, "PS1='$ '; clear")
            await_that(lambda t=terminal: self.screen(t).strip() == "$", "a shell")

    def __call__(self, *words):
        return subprocess.run(["tmux", "-S", self.socket, "-f", "/dev/null", *words], env=self.environment, text=True,
                              capture_output=True, check=True, timeout=TIMEOUT).stdout

    def type(self, terminal, line):
        self("send-keys", "-t", terminal, line, "Enter")

    def screen(self, terminal):
        return self("capture-pane", "-p", "-t", terminal)

    def finish(self):
        subprocess.run(["tmux", "-S", self.socket, "kill-server"], env=self.environment, check=False)


def await_that(holds, what):
    deadline = time.monotonic() + TIMEOUT
    while not holds():
        if time.monotonic() > deadline:
            raise SystemExit(f"{what}: not within {TIMEOUT} s")
        time.sleep(0.05)


def has_answered(screen, lines):
    """One look at the terminal: the prompt is back after this many lines."""
    return screen.rstrip().endswith("$") and screen.count("$ mrroc") == lines


def task_state(binary, environment):
    """Of the run; empty while a process of a started task has not yet said that it runs, or the arm moves by no instruction."""
    done = subprocess.run([binary / "bin/mrroc", "status", "press", "--json"], env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return ""
    state = json.loads(done.stdout)
    running = all(process["state"] == "running" for process in state["processes"])
    moving = any(process["name"] == "arm" and process["instruction"] > 0 for process in state["processes"])
    return state["task"] if state["task"] == "held" or (running and moving) else ""


def transcript(root, binary, folder):
    environment = {**os.environ, "PATH": f"{binary}/bin:{os.environ['PATH']}", "MRROC_RUNTIME_DIR": f"{folder}/run", "LANG": "C.UTF-8",
                   "TERM": "xterm-256color"}
    (pathlib.Path(folder) / "slow.toml").write_text(SLOW, encoding="utf-8")
    tmux = Tmux(folder, environment)
    try:
        tmux.type("run", f"mrroc run {root}/tasks/press/press.toml --clock paced --hold --black-box '' --events {folder}/slow.toml")
        await_that(lambda: task_state(binary, environment) == "held", "the run is held")
        for number, (line, state) in enumerate(SESSION, 1):
            tmux.type("operator", line)
            await_that(lambda n=number: has_answered(tmux.screen("operator"), n), line)
            if state:
                await_that(lambda s=state: task_state(binary, environment) == s, f"{line}: {state}")
        await_that(lambda: tmux.screen("run").rstrip().endswith("$"), "the run ends")
        lines = tmux.screen("operator").rstrip().removesuffix("$").rstrip().splitlines()
        return "\n".join(line.rstrip() for line in lines if not line.startswith("speed ")) + "\n"
    finally:
        tmux.finish()


def normalised(text):
    """Without numbers, and without what depends on the moment."""
    lines = [re.sub(r"\d+(\.\d+)?", "#", line) for line in text.splitlines()]
    return [re.sub(r"\s+", " ", re.sub(r" # [A-Za-z].*, step #$", "", line)).strip() for line in lines]


def main():
    root, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    text = (root / PAGE).read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    there, after = rest.split(END)
    with tempfile.TemporaryDirectory() as folder:
        seen = transcript(root, binary, folder)
    if "--write" in sys.argv:
        (root / PAGE).write_text(f"{before}{BEGIN}\n```text\n{seen}```\n\n{END}{after}", encoding="utf-8")
        return 0
    shown = there.strip().removeprefix("```text\n").removesuffix("```")
    if normalised(shown) != normalised(seen):
        print("\n".join(difflib.unified_diff(normalised(shown), normalised(seen), PAGE, "seen", lineterm="")))
        print(f"{PAGE}: the transcript differs, tests/docs/check_transcript.py . build --write. Seen:\n{seen}")
        return 1
    print(f"{len(SESSION)} commands")
    return 0


sys.exit(main())
