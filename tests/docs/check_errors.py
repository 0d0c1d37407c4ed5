"""Compares docs/reference/errors.md with the source: the table has every code of ErrorCode with its number, its text, the class that its
number stands for and the parts of the project that report it, and nothing else.

Usage: check_errors.py SOURCE_DIR
"""

import pathlib
import re
import sys

PAGE = "docs/reference/errors.md"
ROW = re.compile(r"^\| (\d+) \| `(\w+)` \| ([^|]*) \| ([^|]*) \| ([^|]*) \| ([^|]*) \|$", re.MULTILINE)
PARTS = {  # word in the table: folders
    "language": ["src/language", "include"],
    "task process": ["src/process"],
    "link": ["src/links"],
    "clock": ["src/clock"],
    "MP": ["mp"],
    "ECP": ["ecp"],
    "EDP": ["edp", "robots", "drivers"],
    "VSP": ["vsp", "sensors"],
    "simulator": ["sim"],
    "mrroc run": ["cli", "src/command"],
}
CODES_THEMSELVES = ("include/mrroc/errors.hpp", "src/core/errors.cpp")


def class_of(number):
    return "non-fatal" if number < 100 else "hardware" if number < 200 else "system"


def codes(root):
    """{name: (number, text)} as in the source."""
    header = (root / CODES_THEMSELVES[0]).read_text(encoding="utf-8")
    body = re.search(r"enum class ErrorCode[^{]*\{(.*?)\};", header, re.DOTALL).group(1)
    numbers = {name: int(number) for name, number in re.findall(r"^ *(\w+) = (\d+)", body, re.MULTILINE)}
    source = (root / CODES_THEMSELVES[1]).read_text(encoding="utf-8")
    texts = dict(re.findall(r'case ErrorCode::(\w+):\s*return "([^"]*)";', source))
    return {name: (number, texts.get(name)) for name, number in numbers.items() if name != "none"}


def reporters(root):
    """{code: parts that name it, except for comparisons with it}."""
    found = {}
    for part, folders in PARTS.items():
        for path in sorted(path for folder in folders for path in (root / folder).rglob("*.[ch]pp")):
            if str(path.relative_to(root)) in CODES_THEMSELVES:
                continue
            text = re.sub(r"[=!]=\s*ErrorCode::\w+|case ErrorCode::\w+|//[^\n]*", "", path.read_text(encoding="utf-8"))
            for code in re.findall(r"ErrorCode::(\w+)", text):
                found.setdefault(code, set()).add(part)
    return found


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    known, reported_by = codes(root), reporters(root)
    rows = ROW.findall((root / PAGE).read_text(encoding="utf-8"))
    problems = []
    for number, name, text, kind, parts, remedy in rows:
        if name not in known:
            problems.append(f"{name} is not a code")
            continue
        expected = (str(known[name][0]), known[name][1], class_of(known[name][0]))
        if (number, text, kind) != expected:
            problems.append(f"{name} is {number}, '{text}', {kind}; expected {', '.join(map(str, expected))}")
        reported = set(parts.split(", "))
        if reported != reported_by.get(name, set()):
            problems.append(
                f"{name} is listed as reported by {sorted(reported)}; in the source: {sorted(reported_by.get(name, set()))}"
            )
        if not remedy.strip():
            problems.append(f"{name}: what may a task do?")
    names = [row[1] for row in rows]
    problems += [f"{name} has no row" for name in known if name not in names]
    problems += [f"{name} has two rows" for name in sorted(set(names)) if names.count(name) > 1]
    if [int(row[0]) for row in rows] != sorted(int(row[0]) for row in rows):
        problems.append("the rows are not in the order of the numbers")
    print("\n".join(f"{PAGE}: {problem}" for problem in problems) or f"{len(rows)} codes")
    return 1 if problems or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
