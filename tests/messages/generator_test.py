"""The generator of messages: its refusals, and its IDL, which the compiler of Cyclone DDS accepts.

Usage: generator_test.py SRC_MESSAGES IDLC
"""

import pathlib
import subprocess
import sys
import tempfile

BAD = {  # text of p/msg/A.msg: what the refusal contains
    "int32 x\nint33 y\n": "type 'p/int33' of y has no file",
    "wstring x\n": "type 'p/wstring' of x has no file",
    "string<=0 x\n": "A.msg:1: 'string<=0 x', expected TYPE NAME",
    "int8<=5 x\n": "A.msg:1: 'int8<=5 x', expected string<=N NAME",
    "string<=5[] x\n": "A.msg:1: 'string<=5[] x', expected string<=N NAME",
    "int32 x 5\n": "A.msg:1: 'int32 x 5', expected TYPE NAME",
    "\nint32 X\n": "A.msg:2: 'int32 X', expected TYPE NAME",
    "int32[0] x\n": "A.msg:1: 'int32[0] x', expected a size of at least 1",
    "int32[<=] x\n": "A.msg:1: 'int32[<=] x', expected a number",
    "bool[] x\n": "A.msg:1: 'bool[] x' is a sequence of booleans",
    "A x\n": "contains itself: p/A > p/A",
    "# only\nint8 X=1\n": "no field, expected at least one",
    "q/B x\n": "type 'q/B' of x has no file",
}


def generate(folder, last):
    return subprocess.run([sys.executable, GENERATOR, str(folder), str(last)], capture_output=True, text=True, check=False)


def check_refusals(folder):
    for text, expected in BAD.items():
        description = folder / "bad/p/msg/A.msg"
        description.parent.mkdir(parents=True, exist_ok=True)
        description.write_text(text, encoding="utf-8")
        found = generate(folder / "bad", folder / "made")
        assert found.returncode == 1 and expected in found.stderr, f"{text!r}: {found.returncode} {found.stderr}"
    assert not (folder / "made").exists(), "a refused description has made files"
    empty = folder / "empty"
    empty.mkdir()
    found = generate(empty, "--outputs")
    assert found.returncode == 1 and "no PACKAGE/msg/NAME.msg" in found.stderr, found.stderr


def check_idl(messages, idlc, folder):
    found = generate(messages / "msg", folder / "made")
    assert found.returncode == 0, found.stderr
    idl = folder / "made/idl"
    files = sorted(idl.glob("*/*/*.idl"))
    assert len(files) == len(list((messages / "msg").glob("*/*/*.msg")))
    for file in files:
        c_files = folder / "c" / file.parts[-3] / file.stem
        c_files.mkdir(parents=True)
        made = subprocess.run([idlc, "-f", "case-sensitive", "-I", str(idl), "-o", str(c_files), str(file)], capture_output=True, text=True, check=False)
        assert made.returncode == 0, f"{file}: {made.stderr}"
        package, kind = file.parts[-3:-1]
        text = "".join(path.read_text(encoding="utf-8") for path in c_files.rglob("*.c"))
        # the name that ROS 2 gives the type on DDS
        assert f'"{package}::{kind}::dds_::{file.stem}_"' in text, f"{file}: type name is missing"
    print(f"{len(BAD)} descriptions refused, {len(files)} IDL files compiled")


if __name__ == "__main__":
    GENERATOR = str(pathlib.Path(sys.argv[1]) / "generate.py")
    with tempfile.TemporaryDirectory() as place:
        check_refusals(pathlib.Path(place))
        check_idl(pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(place))
