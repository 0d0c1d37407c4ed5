"""A user's project, built outside the tree with find_package(mrroc): the robot and the sensor type of docs/examples, and a task.

Usage: check_package.py SOURCE_DIR BINARY_DIR [--installed] [-Dcache=entry ...]

With --installed it is built against an installation in a separate folder, else against the build folder itself.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

MOST_LINES = {"slide": 150, "gauge": 60, "stream": 120}  # limits for a robot with one axis, a sensor, and a driver with its stand-in
NOT_COUNTED = {"stream": {"demo.toml", "slide.toml"}}  # a robot and a deployment for the driver


def execute(command, cwd=None):
    # the project must find its dependencies without help
    environment = {name: value for name, value in os.environ.items() if not name.startswith("MRROC_")}
    return subprocess.run(
        [str(part) for part in command], cwd=cwd, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
    )


def run(*command, cwd=None):
    """Output of a command that must succeed."""
    done = execute(command, cwd)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def check_size(example):
    lines = sum(len(file.read_text(encoding="utf-8").splitlines()) for file in example.rglob("*")
                if file.is_file() and file.name not in NOT_COUNTED.get(example.name, ()))
    if lines > MOST_LINES[example.name]:
        sys.exit(f"{example}: {lines} lines, expected at most {MOST_LINES[example.name]}")
    return lines


def make_project(source, folder):
    project = folder / "project"
    shutil.copytree(source / "tests/package/project", project)
    for example in MOST_LINES:
        shutil.copytree(source / "docs/examples" / example, project / example)
    return project


def check_commands(build, source, installed):
    """The framework's own build options do not reach its users, and an installation does not refer to its source."""
    commands = (build / "compile_commands.json").read_text(encoding="utf-8")
    if "-Werror" in commands:
        sys.exit("the framework's warnings are enabled in the user's build")
    if installed and f"{source}/" in commands:
        sys.exit("the installation refers to the source tree")


def check_run(build, deployment):
    """Two runs of a deployment: equal to the last bit, and the recording has steps of Move and keeps the rules."""
    hashes = set()
    for number in (1, 2):
        recording = build / f"{deployment.stem}_{number}.mcap"
        run(build / "bin/mrroc", "run", "--quiet", deployment, "--record", recording)
        if '"is_move":true' not in run(build / "bin/mrroc", "trace", "cat", recording):
            sys.exit(f"{deployment}: no step of a Move was made")
        run(build / "bin/mrroc", "trace", "check", recording)
        hashes.add(run(build / "bin/mrroc", "trace", "hash", recording))
    if len(hashes) != 1:
        sys.exit(f"{deployment}: two runs differ: {hashes}")


def check_driver(build, project):
    """The driver of the example moves the slide over UDP, from its stand-in's positions; a second library takes its name in vain."""
    demo = (build / "bin/mrroc", "run", "--quiet", project / "stream/demo.toml")
    controller = subprocess.Popen([build / "stream/stream_controller", "5005"])
    try:
        run(*demo)
    finally:
        controller.kill()
        controller.wait()
    library = build / "lib/mrroc/drivers/stream.so"
    library.write_bytes(b"no library")
    done = execute(demo)
    if done.returncode == 0 or "stream.so" not in done.stdout or "expected a shared library" not in done.stdout:
        sys.exit(f"an invalid library: exit code {done.returncode}\n{done.stdout}")


def main():
    source, binary = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    installed = "--installed" in sys.argv
    lines = check_size(source / "docs/examples/slide")
    with tempfile.TemporaryDirectory(prefix="mrroc_package_") as scratch:
        folder = pathlib.Path(scratch).resolve()
        prefix = folder / "prefix" if installed else binary
        if installed:
            run("cmake", "--install", binary, "--prefix", prefix)
        project = make_project(source, folder)
        build = project / "build"
        options = ["-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", f"-DCMAKE_PREFIX_PATH={prefix}"]
        run("cmake", "-S", project, "-B", build, *options, *(entry for entry in sys.argv[3:] if entry.startswith("-D")))
        run("cmake", "--build", build, "--parallel", "2")
        check_commands(build, source, installed)
        check_run(build, project / "slide/demo.toml")
        check_run(build, project / "measure.toml")
        check_driver(build, project)
        run(build / "measure_test")
        limits = run(build / "bin/slide_edp", "limits")
        if "carriage" not in limits:
            sys.exit(f"slide_edp limits: {limits}")
    print(f"{lines} lines of robot, four runs")


if __name__ == "__main__":
    main()
