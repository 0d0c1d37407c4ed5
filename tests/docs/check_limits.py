"""Holds the pages of docs/reference/robots/ to the parameter files: each has the table that its robot's EDP prints as its limits.

Usage: check_limits.py SOURCE_DIR BINARY_DIR
"""

import pathlib
import subprocess
import sys


def main():
    root, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    problems = []
    robots = sorted(folder.name for folder in (root / "robots").iterdir() if (folder / f"{folder.name}.toml").exists())
    for robot in robots:
        table = subprocess.run([binary / f"bin/{robot}_edp", "limits"], capture_output=True, text=True, check=True).stdout
        page = root / f"docs/reference/robots/{robot}.md"
        if f"\n\n{table}\n" not in page.read_text(encoding="utf-8"):
            problems.append(f"{page.relative_to(root)}: this is what `{robot}_edp limits` prints, the page has not:\n{table}")
    print("\n".join(problems) or f"{len(robots)} pages have the limits of their robots")
    return 1 if problems or not robots else 0


if __name__ == "__main__":
    sys.exit(main())
