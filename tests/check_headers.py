"""Compares the lists of installed headers with what the public headers include: no header is missing or superfluous.

Usage: check_headers.py SOURCE_DIR
"""

import pathlib
import re
import sys

ROOTS = ("", "src/", "include/", "mp/include/", "ecp/include/", "testing/include/")
FOLDERS = ("include", "mp/include", "ecp/include", "testing/include", "robots")  # installed whole


def listed(text, name):
    return re.search(rf"set\({name}\n(.*?)\)", text, re.S).group(1).split()


def included_by(root, path):
    text = (root / path).read_text(encoding="utf-8")
    for given in re.findall(r"^\s*#\s*include\s+[<\"]([^\">]+)", text, re.M):
        beside = (pathlib.PurePosixPath(path).parent / given).as_posix()
        found = next((name for name in (beside, *(top + given for top in ROOTS)) if (root / name).is_file()), None)
        if found:
            yield found


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    text = (root / "cmake/MrrocHeaders.cmake").read_text(encoding="utf-8")
    public, included = listed(text, "MRROC_PUBLIC_HEADERS"), listed(text, "MRROC_INCLUDED_HEADERS")
    whole = [path for top in FOLDERS for path in (root / top).rglob("*.hpp")] + list(root.glob("sensors/*/include/**/*.hpp"))
    seen = {path.relative_to(root).as_posix() for path in whole} | set(public)
    wanted, unread = set(), sorted(seen)
    while unread:
        for name in included_by(root, unread.pop()):
            if name not in seen:
                seen.add(name)
                wanted.add(name)
                unread.append(name)
    problems = [f"cmake/MrrocHeaders.cmake: {name} is included by a public header and not installed" for name in sorted(wanted - set(included))]
    problems += [f"cmake/MrrocHeaders.cmake: {name} is installed and no public header includes it" for name in sorted(set(included) - wanted)]
    print("\n".join(problems) or f"{len(public)} public headers beside folders, {len(included)} that they include")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
