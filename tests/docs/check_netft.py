"""Compares the tables of docs/how-to/netft.md with the source: every key of netft.toml with its default and unit, the
texts of the errors.

Usage: check_netft.py SOURCE_DIR
"""

import pathlib
import re
import sys
import tomllib

PAGE = "docs/how-to/netft.md"


def rows(page, header):
    """Cells of the rows of the table that begins with `header`."""
    table = re.search(rf"^{re.escape(header)}\n\|[-|]+\n((?:\|.*\n)+)", page, re.MULTILINE)
    return [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in table.group(1).splitlines()]


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    page = (root / PAGE).read_text(encoding="utf-8")
    problems = [f"{PAGE}:{number}: longer than 120 characters"
                for number, line in enumerate(page.splitlines(), 1) if len(line) > 120 and not line.startswith("|")]
    declared = tomllib.loads((root / "drivers/netft/netft.toml").read_text(encoding="utf-8"))["parameters"]
    listed = {}
    for key, unit, _, default in rows(page, "| key | unit | value | default |"):
        listed[key.strip("`")] = (unit, default)
    for key in sorted(declared.keys() | listed.keys()):
        if key not in listed or key not in declared:
            problems.append(f"{key}: only in {'netft.toml' if key in declared else PAGE}")
            continue
        default = declared[key].get("default")
        shown = "required" if default is None else f'"{default}"' if isinstance(default, str) else f"{default:g}"
        expected = (declared[key].get("unit", ""), shown)
        if listed[key] != expected:
            problems.append(f"{key}: {listed[key]} on the page, {expected} in netft.toml")
    source = " ".join(path.read_text(encoding="utf-8") for path in sorted((root / "drivers/netft").glob("*.cpp")))
    for text in ("no record within ", "no complete answer within ", "comrdtrate", "RDT is disabled", "scfgfu",
                 "the Net F/T reports status ", "transducer saturation or A/D error", "monitor condition latched",
                 "the Net F/T has restarted and lost its zero"):
        if text not in page or text not in source:
            problems.append(f"'{text}': not both on the page and in drivers/netft")
    print("\n".join(problems) or f"{len(declared)} keys as declared")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
