"""Compares tests/fuzz/messages.cpp with src/links/wire/messages.idl: every transmitted struct, one with a Header, is fuzzed once,
in an array of exactly that length.

Usage: check_messages.py SOURCE_DIR
"""

import collections
import pathlib
import re
import sys

IDL = "src/links/wire/messages.idl"
FUZZER = "tests/fuzz/messages.cpp"
STRUCT = re.compile(r"\bstruct (\w+) \{(.*?)\};", re.DOTALL)
FUZZED = re.compile(r"std::make_unique<TypeOf<(?:\w+::)*(\w+)>>")
LENGTH = re.compile(r"std::array<std::unique_ptr<Type>, (\d+)>")
COMMENT = re.compile(r"//.*")


def main():
    root = pathlib.Path(sys.argv[1])
    idl, fuzzer = (COMMENT.sub("", (root / file).read_text(encoding="utf-8")) for file in (IDL, FUZZER))
    travelling = {name for name, body in STRUCT.findall(idl) if re.search(r"\bHeader \w+;", body)}
    fuzzed = collections.Counter(FUZZED.findall(fuzzer))
    problems = [f"{name} of {IDL} is not fuzzed" for name in sorted(travelling - fuzzed.keys())]
    problems += [f"{name} is not a message of {IDL}" for name in sorted(fuzzed.keys() - travelling)]
    problems += [f"{name} is fuzzed {count} times" for name, count in fuzzed.items() if count > 1]
    # a longer array would end in empty types
    if LENGTH.findall(fuzzer) != [str(fuzzed.total())]:
        problems.append(f"its array is for {LENGTH.findall(fuzzer)} types, it has {fuzzed.total()}")
    print("\n".join(f"{FUZZER}: {problem}" for problem in problems) or f"{len(travelling)} messages are fuzzed")
    return 1 if problems or not travelling else 0


if __name__ == "__main__":
    sys.exit(main())
