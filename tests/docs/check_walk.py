"""Checks that every stop of docs/explanation/one-move-step.md is in the sources: the linked file has the named function.

Usage: check_walk.py SOURCE_DIR
"""

import pathlib
import re
import sys


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    page = root / "docs/explanation/one-move-step.md"
    stops = re.findall(r"^\| (\d+) \|.*?\]\((\S+?)\) \| `(\w+)` \|", page.read_text(encoding="utf-8"), re.M)
    problems = [f"stop {number}, expected {index}" for index, (number, _, _) in enumerate(stops, 1) if int(number) != index]
    for number, link, function in stops:
        file = (page.parent / link).resolve()
        if not file.is_file() or not re.search(rf"\b{function}\b", file.read_text(encoding="utf-8")):
            problems.append(f"stop {number}: no '{function}' in {link}")
    print("\n".join(problems) or f"{len(stops)} stops")
    return 1 if problems or len(stops) < 15 else 0


if __name__ == "__main__":
    sys.exit(main())
