"""Checks that every test has exactly one of the labels fast and slow: `make check` would silently skip a test without one.

Usage: check_labels.py CTEST BINARY_DIR
"""

import json
import subprocess
import sys

SPEEDS = {"fast", "slow"}


def labels(test):
    return {label for entry in test["properties"] if entry["name"] == "LABELS" for label in entry["value"]}


def main():
    ctest, binary = sys.argv[1:]
    listed = subprocess.run([ctest, "--test-dir", binary, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    tests = json.loads(listed.stdout)["tests"]
    wrong = [test["name"] for test in tests if len(labels(test) & SPEEDS) != 1]
    for name in wrong:
        print(f"{name}: expected one of the labels fast and slow; mrroc_test and mrroc_script_test give it")
    print(f"{len(tests)} tests, {sum('fast' in labels(test) for test in tests)} fast")
    return 1 if wrong or not tests else 0


if __name__ == "__main__":
    sys.exit(main())
