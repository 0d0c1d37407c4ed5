"""Checks that no process of a deployment has variables of this project outside objects, neither globals nor static locals, which
would carry state from one robot or motion to another. Exceptions must be in the list below, with their reasons.

Usage: check_globals.py NM BINARY_DIR
"""

import pathlib
import re
import subprocess
import sys

ALLOWED = {
    # the only variables that a signal handler can access
    "mrroc::process::(anonymous namespace)::asked",
    "mrroc::process::(anonymous namespace)::interruptible",
    "mrroc::process::(anonymous namespace)::runner",
    "mrroc::process::(anonymous namespace)::setting_up",
    "mrroc::edp::(anonymous namespace)::call_under_way",
    "mrroc::edp::(anonymous namespace)::crashing_driver",
    # per thread, during the lifetime of a scope object of the same name: the object under construction
    "mrroc::process::(anonymous namespace)::current",
    "mrroc::sim::(anonymous namespace)::innermost",
    # DDS and MuJoCo have one log per process
    "mrroc::links::(anonymous namespace)::the_log()::log",
    "guard variable for mrroc::sim::MujocoMessages::MujocoMessages()::installed",
    "mrroc::sim::MujocoMessages::MujocoMessages()::installed",
    # Cyclone's functions behind wrappers of the same name, or of its plug-in, looked up once: in C there is no object for them
    "mrroc::links::(anonymous namespace)::plugin",
    "guard variable for mrroc::links::authentication_library(std::filesystem::__cxx11::path const&)::opened",
    "mrroc::links::authentication_library(std::filesystem::__cxx11::path const&)::opened",
    "guard variable for mrroc::links::(anonymous namespace)::cyclone_valid()::function",
    "mrroc::links::(anonymous namespace)::cyclone_valid()::function",
    "guard variable for mrroc::links::(anonymous namespace)::cyclone_reorder()::function",
    "mrroc::links::(anonymous namespace)::cyclone_reorder()::function",
    "guard variable for mrroc::links::(anonymous namespace)::cyclone_gap()::function",
    "mrroc::links::(anonymous namespace)::cyclone_gap()::function",
    "guard variable for mrroc::links::(anonymous namespace)::cyclone_dispatch()::function",
    "mrroc::links::(anonymous namespace)::cyclone_dispatch()::function",
    # of Cyclone's hand-shake thread, between two of its calls
    "mrroc::links::(anonymous namespace)::makes_final_message",
    # restrictions of the sockets that Cyclone binds in this thread
    "guard variable for mrroc::links::(anonymous namespace)::cyclone_bind()::function",
    "mrroc::links::(anonymous namespace)::cyclone_bind()::function",
    "mrroc::links::(anonymous namespace)::limit_device",
    "mrroc::links::(anonymous namespace)::limit_other",
    # the behaviours of a program, registered before main
    "guard variable for mrroc::ecp::(anonymous namespace)::entered()::behaviours",
    "mrroc::ecp::(anonymous namespace)::entered()::behaviours",
}
# one per message type of a program: its registration
ENTERED = re.compile(r"(?:guard variable for )?mrroc::ecp::Behaviours::(?:On|Tells)<.*>::kEntered$")
OURS = re.compile(r"(?:guard variable for )?mrroc::")
# a section with such a name is writable while the process runs; .data.rel.ro is not
WRITABLE = re.compile(r"\.(?:bss|data|tbss|tdata)\b(?!\.rel\.ro)")


def is_program(path):
    with path.open("rb") as file:
        return path.is_file() and file.read(4) == b"\x7fELF"


def variables(nm, program):
    """Names of the project's variables in a program."""
    table = subprocess.run([nm, "--demangle", "--format=sysv", program], capture_output=True, text=True, check=True).stdout
    for line in table.splitlines():
        # name|value|class|type|size|line|section; a name may itself have a bar in it
        fields = [field.strip() for field in line.rsplit("|", 6)]
        if len(fields) == 7 and OURS.match(fields[0]) and WRITABLE.match(fields[6]):
            yield fields[0]


def main():
    nm, binary = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    programs = sorted(path for path in (binary / "bin").iterdir() if path.is_file() and is_program(path))
    problems, seen = [], set()
    for program in programs:
        names = set(variables(nm, program))
        seen |= names
        problems += [f"{program.name}: {name}" for name in sorted(names - ALLOWED) if not ENTERED.match(name)]
    if "mrroc::process::(anonymous namespace)::asked" not in seen:
        problems.append("the variables that every process has are not found: the search finds nothing")
    print("\n".join(problems) or f"{len(programs)} programs have {len(seen)} known variables and no other")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
