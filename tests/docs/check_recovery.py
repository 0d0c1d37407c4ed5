"""Compares docs/reference/recovery.md with its picture and the tests: every edge of the graph has a row, every row is an edge of the graph
between the same states, names at least one test, and every test that it names is in a file that is built.

Usage: check_recovery.py SOURCE_DIR BINARY_DIR
"""

import html
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from check_defects import files_built, named, tests_in

PAGE = "docs/reference/recovery.md"
GRAPH = "docs/pictures/recovery.dot"
PICTURE = "docs/pictures/recovery.svg"
ROW = re.compile(r"^\| (\d+) \| ([^|]+) \| ([^|]+) \| [^|]+ \| ([^|]*) \|$", re.MULTILINE)
STATE = re.compile(r'^  (\w+) \[label = "([^"]*)"', re.MULTILINE)
EDGE = re.compile(r'^  (\w+) -> (\w+) \[label = "(\d+) ([^"]*)"\]', re.MULTILINE)


def main():
    root, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    built = files_built(binary)
    graph = (root / GRAPH).read_text(encoding="utf-8")
    states = {node: label.split("\\n")[0] for node, label in STATE.findall(graph)}
    edges = {int(number): (states[start], states[end]) for start, end, number, _ in EDGE.findall(graph)}
    picture = html.unescape((root / PICTURE).read_text(encoding="utf-8"))
    rows = {}
    problems = []
    for number, start, end, cell in ROW.findall((root / PAGE).read_text(encoding="utf-8")):
        if int(number) in rows:
            problems.append(f"way {number} has two rows")
        rows[int(number)] = (start, start if end == "the same" else end)
        tests = list(named(cell))
        if not tests:
            problems.append(f"way {number}: no test is named")
        for file, test in tests:
            path = root / file
            if not path.is_file() or test not in tests_in(path):
                problems.append(f"way {number}: {file} has no test {test}")
            elif path not in built:
                problems.append(f"way {number}: {file} is not built")
    problems += [f"way {number} of {GRAPH} has no row" for number in edges if number not in rows]
    for number, ends in rows.items():
        if edges.get(number) != ends:
            problems.append(f"way {number} leads from {ends[0]} to {ends[1]}; in {GRAPH}: {edges.get(number)}")
    for _, _, number, text in EDGE.findall(graph):
        if f">{number} {text}</text>" not in picture:
            problems.append(f"{PICTURE} does not show way {number} '{text}': draw it again with dot -Tsvg")
    print("\n".join(f"{PAGE}: {problem}" for problem in problems) or f"{len(rows)} edges")
    return 1 if problems or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
