"""Compares docs/reference/original-defects.md with the tests: every defect has its row, every named test is in the named file
and that file is built, and a test whose comment names a defect is listed at that defect.

Usage: check_defects.py SOURCE_DIR BINARY_DIR
"""

import json
import pathlib
import re
import sys

DEFECTS = 27
PAGE = "docs/reference/original-defects.md"
ROW = re.compile(r"^\| (\d+) \|.*\| ([^|]*) \|$", re.MULTILINE)
TEST = r"(?:TYPED_)?TEST(?:_F|_P)?\((\w+), (\w+)\)"
UNITY = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
ABOUT = re.compile(rf"^// [^\n]*\bdefect (\d+)\b[^\n]*\n{TEST}", re.MULTILINE)


def named(cell):
    """(file, test) of each test that a cell of the table names: `file`: `test`, `test`; `file`: ..."""
    for part in cell.split("; "):
        file, *tests = re.findall(r"`([^`]+)`", part)
        yield from ((file, test) for test in tests)


def tests_in(path):
    """Names of the tests of a C++ file, or of the scripts that a CMakeLists.txt adds as tests."""
    text = path.read_text(encoding="utf-8")
    if path.name == "CMakeLists.txt":
        return set(re.findall(r"(?:mrroc_script_test\(|add_test\(NAME )(\w+)", text))
    return {f"{suite}.{test}" for suite, test in re.findall(rf"^{TEST}", text, re.MULTILINE)}


def files_built(binary):
    """The source files that are compiled, alone or in a unity build as parts of files that CMake has generated."""
    units = [pathlib.Path(unit["file"]) for unit in json.loads((binary / "compile_commands.json").read_text(encoding="utf-8"))]
    parts = (UNITY.findall(unit.read_text(encoding="utf-8")) for unit in units if unit.parent.name == "Unity" and unit.exists())
    return {*units, *(pathlib.Path(part) for file in parts for part in file)}


def main():
    root, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    built = files_built(binary)
    rows = {int(number): list(named(cell)) for number, cell in ROW.findall((root / PAGE).read_text(encoding="utf-8"))}
    problems = [f"defect {n} has no line" for n in range(1, DEFECTS + 1) if n not in rows]
    for number, tests in rows.items():
        if not tests:
            problems.append(f"defect {number}: no test is named")
        for file, test in tests:
            path = root / file
            if not path.is_file() or test not in tests_in(path):
                problems.append(f"defect {number}: {file} has no test {test}")
            elif path.suffix == ".cpp" and path not in built:
                problems.append(f"defect {number}: {file} is not built")
    for path in sorted((root / "tests").rglob("*.cpp")):
        for number, suite, test in ABOUT.findall(path.read_text(encoding="utf-8")):
            where = (str(path.relative_to(root)), f"{suite}.{test}")
            if where not in rows.get(int(number), []):
                problems.append(f"{where[0]}: {where[1]} names defect {number} in its comment, but the row of that defect does not list it")
    print("\n".join(f"{PAGE}: {problem}" for problem in problems) or f"{sum(map(len, rows.values()))} tests found")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
