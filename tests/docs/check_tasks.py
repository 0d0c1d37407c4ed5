"""Compares docs/reference/tasks.md with tasks/: a row for each task, with the description in its deployment and the length of its program.

Lines are those that are neither empty nor comment only. The program: the C++ files in the task's folder (not in folders
below it), except parts: a header with its own source file that is not a process, and that file.

Usage: check_tasks.py SOURCE_DIR
"""

import pathlib
import re
import sys


def is_program(path):
    return re.search(r"^MRROC_(ECP|MP)\(", path.with_suffix(".cpp").read_text(encoding="utf-8"), re.MULTILINE)


def lines_of(folder):
    """Number of lines of the program, and of its parts."""
    counts = {True: 0, False: 0}
    for path in [*folder.glob("*.cpp"), *folder.glob("*.hpp")]:
        code = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        is_part = path.with_suffix(".hpp").exists() and path.with_suffix(".cpp").exists() and not is_program(path)
        counts[is_part] += sum(1 for line in code.splitlines() if line.strip() and not line.strip().startswith("//"))
    return f"{counts[False] or 'none'} | {counts[True] or ''}".strip()


def says(deployment):
    """The comment above the deployment, without the instructions to run it."""
    words = []
    for line in deployment.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        words.append(line.lstrip("# "))
    return " ".join(words).split(" Run it:")[0]


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    page = root / "docs/reference/tasks.md"
    text = page.read_text(encoding="utf-8")
    rows = []
    for deployment in sorted(root.glob("tasks/*/*.toml")):
        folder = deployment.parent
        if deployment.stem == folder.name:
            rows.append(f"| [{folder.name}](../../tasks/{folder.name}) | {says(deployment)} | {lines_of(folder)} |")
    missing = [row for row in rows if f"\n{row}\n" not in text]
    print("\n".join(["docs/reference/tasks.md lacks these rows of its table:", *missing]) if missing else f"{len(rows)} tasks")
    return 1 if missing or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
