"""Checks README.md and docs/: every ```sh line is run, every ```cpp block of a task program is in a source
file, every ```toml block parses, every linked file exists, docs/README.md lists every page, CHANGELOG.md starts with the version that mrroc prints.

Usage: check_docs.py SOURCE_DIR BINARY_DIR
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

# run by CI itself, or the subject of the page: running them here would run the tests within the tests
NOT_RUN_HERE = ("make ", "ctest ", "cmake ")


def blocks(text, language):
    """(line number, content) of each fenced block of a language."""
    for match in re.finditer(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        yield text[: match.start()].count("\n") + 2, match.group(1)


def sources(root):
    """Text of every C++ file that a snippet may quote."""
    for folder in ("tasks", "tests", "robots", "sensors", "include", "src", "edp", "drivers", "vsp", "mp", "ecp", "sim", "docs/examples"):
        for path in (root / folder).rglob("*.[ch]pp"):
            yield path.read_text(encoding="utf-8")


def squeeze(text):
    """Layout does not count: clang-format may indent the quoted code further."""
    return re.sub(r"\s+", " ", text).strip()


def main():
    root, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    problems = []
    code = [squeeze(text) for text in sources(root)]
    commands = 0
    scratch = tempfile.mkdtemp(prefix="mrroc_docs_")  # files in /tmp may be another user's
    for page in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        text = page.read_text(encoding="utf-8")
        name = page.relative_to(root)
        for line, block in blocks(text, "cpp"):
            if not any(squeeze(block) in source for source in code):
                problems.append(f"{name}:{line}: this code is in no source file")
        for line, block in blocks(text, "toml"):
            try:
                tomllib.loads(block)
            except tomllib.TOMLDecodeError as error:
                problems.append(f"{name}:{line}: {error}")
        for line, block in blocks(text, "sh"):
            for command in block.splitlines():
                if not command.strip() or command.startswith(NOT_RUN_HERE):
                    continue
                commands += 1
                here = command.replace("build/", f"{binary}/").replace("/tmp/", f"{scratch}/")
                own = {**os.environ, "MRROC": f"{binary}/bin/mrroc"}  # a plot reads with the program of this build
                done = subprocess.run(here, shell=True, cwd=root, env=own, capture_output=True, text=True, check=False)
                if done.returncode != 0:
                    problems.append(f"{name}:{line}: {command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        # a lambda in a code block looks like a link: only its line breaks are kept
        prose = re.sub(r"^```.*?^```", lambda code: "\n" * code.group().count("\n"), text, flags=re.MULTILINE | re.DOTALL)
        for match in re.finditer(r"\]\(([^)#:]+)\)", prose):
            if not (page.parent / match.group(1)).exists():
                line = prose[: match.start()].count("\n") + 1
                problems.append(f"{name}:{line}: {match.group(1)} does not exist")
    index = (root / "docs/README.md").read_text(encoding="utf-8")
    for page in sorted((root / "docs").rglob("*.md")):
        name = page.relative_to(root / "docs").as_posix()
        if name != "README.md" and f"({name})" not in index and not name.startswith(("reference/robots/", "examples/")):
            problems.append(f"docs/README.md has no link to {name}")
    numbers = [page.name[:4] for page in sorted((root / "docs/decisions").glob("*.md"))]
    if numbers != [f"{number:04d}" for number in range(1, len(numbers) + 1)]:
        problems.append(f"docs/decisions: {numbers}, expected 0001, 0002, ... once each")
    version = subprocess.run([binary / "bin/mrroc", "--version"], capture_output=True, text=True, check=True).stdout.split()[-1]
    if not re.match(rf"# Changelog\n\n## {re.escape(version)}, \d{{4}}-\d\d-\d\d\n", (root / "CHANGELOG.md").read_text(encoding="utf-8")):
        problems.append(f"CHANGELOG.md does not start with '## {version}, YYYY-MM-DD', the version that mrroc --version prints")
    shutil.rmtree(scratch)
    print("\n".join(problems) or f"{commands} commands run, every snippet and link found")
    return 1 if problems or commands == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
