"""Checks that docs/reference/operator.md contains the table of the operator's verbs as the command describes them.

check_operator.py SOURCE_DIR BINARY_DIR [--write]: --write puts the table into the page.
"""

import pathlib
import subprocess
import sys

PAGE = "docs/reference/operator.md"
BEGIN, END = "<!-- verbs -->\n", "<!-- end -->"


def main():
    root, binary = (pathlib.Path(argument) for argument in sys.argv[1:3])
    table = subprocess.run([binary / "cli/mrroc_manual", "verbs"], capture_output=True, text=True, check=True).stdout
    text = (root / PAGE).read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    there, after = rest.split(END)
    if "--write" in sys.argv:
        (root / PAGE).write_text(before + BEGIN + "\n" + table + "\n" + END + after, encoding="utf-8")
    elif there.strip() != table.strip():
        print(f"{PAGE}: the table of verbs differs from the command's: tests/docs/check_operator.py . build --write")
        return 1
    print(f"{table.count(chr(10)) - 2} verbs")
    return 0


sys.exit(main())
