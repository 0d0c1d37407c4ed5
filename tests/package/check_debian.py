"""Checks the Debian packages: lintian finds no error; in a clean Debian 12 they install, run the task press as an ordinary user, build a user's
project, and leave no files after a purge. Needs no root: a user namespace with one user. The first run needs the machine's package mirror.

Usage: check_debian.py SOURCE_DIR BINARY_DIR CPACK SINGLE_USER_LIBRARY
"""

import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys

import check_package

SUITE = "bookworm"
TOOLS = ["ca-certificates", "libgtest-dev", "make", "mount"]  # of tests/package/project and its test, and of debian/enter
DEVICES = "null zero full random urandom tty"


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], check=False, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout or ''}")
    return done.stdout or ""


def make_packages(binary, cpack, folder):
    shutil.rmtree(folder, ignore_errors=True)
    run(cpack, "-G", "DEB", "--config", binary / "CPackConfig.cmake", "-B", folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    packages = sorted(folder.glob("*.deb"))
    if [package.name.split("_")[0] for package in packages] != ["libmrroc-dev", "mrroc"]:
        sys.exit(f"packages {packages}, expected libmrroc-dev and mrroc")
    return packages


def dependencies(packages):
    """Names of the packages that these depend on, except each other; the first of alternatives."""
    names = set()
    for package in packages:
        for entry in run("dpkg-deb", "-f", package, "Depends", stdout=subprocess.PIPE).split(","):
            names.add(re.match(r"[a-z0-9+.-]+", entry.strip()).group())
    return sorted(names - {package.name.split("_")[0] for package in packages})


def mirrors():
    """Lines of a sources.list: the Debian sources of this machine's apt."""
    listed = run("apt-get", "indextargets", "--format", "$(ORIGIN) $(REPO_URI) $(RELEASE) $(COMPONENT)", "Created-By: Packages", stdout=subprocess.PIPE)
    entries = {tuple(line.split()[1:4]) for line in listed.splitlines() if line.startswith("Debian ")}
    return [f"deb {uri} {release} {component}" for uri, release, component in sorted(entries) if release.startswith(SUITE)]


def make_base(folder, include, library):
    """A Debian with these packages, kept in the build folder for the next run."""
    key = hashlib.sha256(" ".join(include).encode()).hexdigest()[:12]
    base = folder / f"base-{key}"
    if (base / "complete").exists():
        return base
    enter = pathlib.Path(__file__).parent / "debian/enter"
    for old in folder.glob("base-*"):
        run(enter, "rm", "-rf", old)
    hooks = [
        "--hook-dir=/usr/share/mmdebstrap/hooks/maybe-merged-usr",
        f'--setup-hook=mkdir -p "$1/{library.parent}" && cp {library} "$1/{library.parent}"',
        f'--extract-hook=for d in {DEVICES}; do rm -f "$1/dev/$d"; : >"$1/dev/$d"; mount --bind /dev/$d "$1/dev/$d"; done',
        f'--customize-hook=for d in {DEVICES}; do umount "$1/dev/$d"; done',
    ]
    proxy = run("apt-config", "dump", "--format", "%f=%v%n", "Acquire::http::Proxy", stdout=subprocess.PIPE).partition("=")[2].strip()
    options = ["--dpkgopt=force-unsafe-io", "--aptopt=APT::Sandbox::User \"root\"", *([f'--aptopt=Acquire::http::Proxy "{proxy}"'] if proxy else [])]
    command = ["mmdebstrap", "--mode=unshare", "--format=directory", "--variant=apt", "--skip=chroot/mount/dev", *hooks, *options,
               f"--include={','.join(include)}", SUITE, base, *mirrors()]
    done = subprocess.run([enter, *map(str, command)], env={**os.environ, "LD_PRELOAD": str(library)}, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout)
        sys.exit("no clean Debian could be made: is the package mirror of this machine's apt reachable?")
    (base / "complete").touch()
    return base


def main():
    source, binary, cpack, library = (pathlib.Path(argument) for argument in sys.argv[1:])
    folder = binary / "debian_test"
    packages = make_packages(binary, cpack, folder / "packages")
    print(run("lintian", "--fail-on", "error", "--tag-display-limit", "3", *packages, stdout=subprocess.PIPE, stderr=subprocess.STDOUT))
    base = make_base(folder, [*dependencies(packages), *TOOLS], library)
    given = folder / "given"
    shutil.rmtree(given, ignore_errors=True)
    given.mkdir()
    check_package.make_project(source, given)
    for file in (*packages, source / "tests/package/debian/in_chroot"):
        shutil.copy(file, given)
    enter = source / "tests/package/debian/enter"
    output = run(enter, "--root", base, "/tmp/given/in_chroot", env={**os.environ, "LD_PRELOAD": str(library), "MRROC_GIVEN": str(given)},
                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(output)
    recording = folder / "press.mcap"
    run(binary / "bin/mrroc", "run", "--quiet", source / "tasks/press/press.toml", "--clock", "lockstep", "--record", recording)
    expected = run(binary / "bin/mrroc", "trace", "hash", recording, stdout=subprocess.PIPE).split()[0]
    if f"hash {expected}" not in output:
        sys.exit(f"the steps of the installed task differ from the build folder's: expected hash {expected}")


if __name__ == "__main__":
    main()
