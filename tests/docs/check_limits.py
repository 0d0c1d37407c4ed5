"""Compares the pages of docs/reference/robots/ with the parameter files: each has the table of limits that its robot's EDP prints, for
every parameter file in the robot's folder.

Usage: check_limits.py SOURCE_DIR BINARY_DIR
"""

import pathlib
import subprocess
import sys


def main():
    root, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    problems = []
    files = [path for path in sorted(root.glob("robots/*/*.toml")) if "\n[[axes]]" in path.read_text(encoding="utf-8")]
    for file in files:
        robot = file.parent.name
        command = [binary / f"bin/{robot}_edp", "limits", "--parameters", file]
        table = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        page = root / f"docs/reference/robots/{robot}.md"
        if f"\n\n{table}\n" not in page.read_text(encoding="utf-8"):
            problems.append(f"{page.relative_to(root)}: the limits of {file.relative_to(root)} are missing:\n{table}")
    print("\n".join(problems) or f"the limits of {len(files)} parameter files are in the pages")
    return 1 if problems or len(files) < 2 else 0


if __name__ == "__main__":
    sys.exit(main())
