#!/usr/bin/env python3
"""Makes robot types of public arms, compares their kinematics with KDL and MuJoCo, and runs the stock demo with each.

Usage: arms.py MRROC CACHE [--only NAME ...] [--runs N] [--postures N] [--table FILE [--pictures FOLDER]]

MRROC is the command, CACHE a folder for the packages, which are fetched by pip when they are missing, and for the types. With --runs
the demo runs N times in lockstep and every run must have the same steps. With --table the results are written as a page.
"""

import argparse
import math
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tomllib
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "scripts"))
import mrroc_trace

PLATFORMS = ("manylinux2014_x86_64", "manylinux_2_28_x86_64", "any")
TIMEOUT = 600  # s, of one command
TOO_SLOW = 'too slow a scene or machine for clock = "real"'
FORCE = (10, 16)  # N: the task stops when it measures the first
SCENE = """<mujoco><compiler angle="radian"/><option timestep="0.001" cone="elliptic"/><worldbody>{}</worldbody>{}</mujoco>"""
# as soft as the workpiece of the task press
PAD = """<body name="pad" pos="{} {} {}"><joint name="pad" type="slide" axis="0 0 1" stiffness="5000" damping="60"/>
<geom type="cylinder" size="0.1 0.01" mass="0.1" solref="0.004 1"/></body>"""
# input 3 of the arm's controller is on: the first value of a unit quaternion that does not turn is 1
RELEASED = """<sensor><framequat name="arm/input_3" objtype="body" objname="pad"/></sensor>"""
PRESS = """[deployment]
name = "press"
clock = "lockstep"
[robots.arm]
type = "{}"
program = "{}"
hardware = "mujoco"
force_sensor = "wrist"
force_limit = [60.0, 60.0, 60.0]
torque_limit = [20.0, 20.0, 20.0]
[sensors.wrist]
type = "force_torque"
robot = "arm"
mode = "interactive"
[sim]
scene = "press.xml"
"""


def fetch(name, package, cache):
    """The unpacked wheel of a package with the SHA-256 in arms.toml."""
    target = cache / "packages" / f"{name}-{package['version']}"
    if target.exists():
        return target
    wheels = cache / "wheels"
    wheels.mkdir(parents=True, exist_ok=True)
    requirement = wheels / f"{name}.txt"
    requirement.write_text(f"{name}=={package['version']} --hash=sha256:{package['sha256']}\n", encoding="utf-8")
    platforms = [word for platform in PLATFORMS for word in ("--platform", platform)]
    command = ["-m", "pip", "download", "--quiet", "--no-deps", "--require-hashes", "--only-binary", ":all:"]
    command += ["--python-version", "3.11", "--implementation", "cp", *platforms, "--dest", wheels, "--requirement", requirement]
    print(f"fetching {name} {package['version']}", flush=True)
    subprocess.run([sys.executable, *command], check=True)
    partial = target.with_name(target.name + ".part")
    shutil.rmtree(partial, ignore_errors=True)
    with zipfile.ZipFile(wheels / package["file"]) as wheel:
        wheel.extractall(partial)
    partial.rename(target)  # so that an interrupted fetch leaves no target
    return target


def free_port(kind):
    """One that was free a moment ago."""
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def by_controller(deployment, source, clock):
    """The deployment with the arm behind a UR controller, and the wrench from a Net F/T or from the controller itself ("netft" or "ur").
    All are simulated, and patient with a busy machine; an emergency stop is wired to the controller."""
    tcp = [free_port(socket.SOCK_STREAM) for _ in range(4)]
    controller = (f'hardware = "ur"\nemergency_stop = 3\nur = {{ address = "127.0.0.1", simulated = true, missed_max = 100, watchdog = 0.5, '
                  f"rtde_port = {tcp[0]}, dashboard_port = {tcp[1]}, script_port = {tcp[2]} }}")
    keys = {"netft": f'address = "127.0.0.1", simulated = true, timeout = 0.5, port = {free_port(socket.SOCK_DGRAM)}, http_port = {tcp[3]}',
            "ur": "timeout = 0.5, start_timeout = 30"}[source]
    sensor = f'mode = "interactive"\nsource = "{source}"\n{source} = {{ {keys} }}'
    return (deployment.replace('clock = "lockstep"', f'clock = "{clock}"').replace('hardware = "mujoco"', controller)
            .replace('mode = "interactive"', sensor))


class Arm:
    """One arm, its folder and what was found about it."""

    def __init__(self, arm, packages, options):
        self.name, self.package = arm["name"], arm["package"]
        self.version = packages[self.package]["version"]
        self.options = options
        self.urdf = fetch(self.package, packages[self.package], options.cache) / arm["urdf"]
        self.tip, self.pad, self.torque = arm.get("tip"), arm.get("press"), arm.get("torque", False)
        self.share = options.cache / "share"
        build = options.mrroc.resolve().parent.parent
        self.environment = dict(os.environ, MRROC_SHARE=f"{self.share}:{build / 'share/mrroc'}")

    def mrroc(self, *words):
        run = subprocess.run([self.options.mrroc, *words], capture_output=True, text=True, env=self.environment, timeout=TIMEOUT)
        if run.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, words))}: exit code {run.returncode}\n{run.stdout}{run.stderr}")
        return run.stdout

    def run(self, deployment, recording):
        """A run; once more, at most three times in all, when the machine is too busy for the real clock."""
        for left in (2, 1, 0):
            try:
                return self.mrroc("run", deployment, "--quiet", "--black-box", "", "--record", recording)
            except RuntimeError as error:
                if TOO_SLOW not in str(error) or not left:
                    raise
                print(f"{self.name}: {TOO_SLOW}, once more", flush=True)

    def add_as(self, name, *options):
        tip = ["--tip", self.tip] if self.tip else []
        return self.mrroc("robot", "add", self.urdf, "--name", name, *tip, "--accept-guesses", "--replace",
                          "--into", self.share / "robots", *options)

    def add(self):
        self.added = self.add_as(self.name)
        self.axes = re.search(r"(\d+) axes", self.added).group(1)
        self.inverse = re.search(r"inverse: (.*)", self.added).group(1)
        guesses = [line for line in self.added.splitlines() if "box around" in line or "a ball of" in line]
        self.bodies = sum(line.count("link '") + int((re.findall(r"and (\d+) more", line) or [0])[0]) for line in guesses)

    def check(self):
        text = self.mrroc("robot", "check", self.name, "--postures", self.options.postures)
        self.kdl, self.mujoco = (re.search(rf"to {other} +(\S+)", text).group(1) for other in ("KDL", "MuJoCo"))
        self.near = re.search(r"nearby +(\d+) of \d+, (\S+) us, at most (\S+) us", text).groups()
        self.home = re.search(r"home +(\d+) of \d+, (\S+) us, at most (\S+) us", text).groups()
        self.branches = re.search(r"branches +(\d+) of", text).group(1)

    def hash_of(self, recording):
        return self.mrroc("trace", "hash", recording).split()[0]

    def demo_of(self, name):
        """The hash of the steps, the same for all runs."""
        hashes = set()
        for number in range(self.options.runs):
            recording = self.share / f"{name}_{number}.mcap"
            self.mrroc("run", self.share / "robots" / name / "demo.toml", "--quiet", "--clock", "lockstep", "--record", recording)
            hashes.add(self.hash_of(recording))
            recording.unlink()
        if len(hashes) > 1:
            raise RuntimeError(f"{name}: {self.options.runs} runs of the demo have {len(hashes)} different hashes")
        return next(iter(hashes), "")

    def demo(self):
        self.hash = self.demo_of(self.name)

    def demo_by_torques(self):
        if not self.torque:
            return
        name = f"{self.name}_torque"
        self.add_as(name, "--drives", "torque")
        lines = [line for line in self.mrroc("robot", "show", name, "--postures", "1").splitlines() if ", regulator " in line]
        margins = [int(number) for line in lines for number in re.findall(r"margin (\d+) deg, (\d+) and (\d+) at", line)[0]]
        if len(lines) != int(self.axes):
            raise RuntimeError(f"{name}: regulators of {len(lines)} axes, expected {self.axes}")
        print(f"{name}: phase margins {min(margins)} to {max(margins)} degrees, demo {self.demo_of(name)[:8]}", flush=True)

    def press(self):
        """The program of the task press, for any arm: down from home onto a pad that is `press` m below the tip."""
        if self.pad is None:
            return
        folder = self.options.cache / "press" / self.name
        folder.mkdir(parents=True, exist_ok=True)
        recording = folder / "press.mcap"

        def states(program, *bodies, change=lambda deployment: deployment):
            (folder / "press.xml").write_text(SCENE.format("".join(bodies), RELEASED if bodies else ""), encoding="utf-8")
            (folder / "press.toml").write_text(change(PRESS.format(self.name, program)), encoding="utf-8")
            self.run(folder / "press.toml", recording)
            return [state for step in mrroc_trace.steps(recording) for state in step.robots.values()]

        x, y, z = states("mrroc_arm_demo")[0].pose[:3]
        pad = PAD.format(x, y, z - self.pad)
        programs = self.options.mrroc.parent.parent / "tests"
        runs = [("", lambda deployment: deployment)]
        if self.options.controllers:
            runs += [(f" by its controller with source = {source}, clock = {clock}, run {number + 1}",
                      lambda text, source=source, clock=clock: by_controller(text, source, clock))
                     for source in ("netft", "ur") for clock in self.options.clocks for number in range(self.options.runs)]
        hashes = {}  # of the steps in lockstep, by the deployment
        for how, change in runs:
            forces = [state.wrench[:3] for state in states(programs / "press_at_home_ecp", pad, change=change) if state.wrench]
            if "lockstep" in how:
                hashes.setdefault(how.split(", run")[0], set()).add(self.hash_of(recording))
            force = max(math.dist(each, forces[0]) for each in forces)  # without the weight behind the sensor
            if not FORCE[0] <= force <= FORCE[1]:
                raise RuntimeError(f"{self.name}: pressed with {force:.1f} N{how}, expected {FORCE[0]} to {FORCE[1]} N")
            print(f"{self.name}: pressed with {force:.1f} N{how}", flush=True)
            if self.options.controllers:
                states(programs / "force_at_home_ecp", pad, change=change)  # ends with an error unless every part holds
                print(f"{self.name}: force law, lead-through and force limit{how}", flush=True)
        for how, different in hashes.items():
            if len(different) > 1:
                raise RuntimeError(f"{self.name}: {self.options.runs} runs{how} have {len(different)} different hashes")
            print(f"{self.name}: one hash of {self.options.runs} runs{how}", flush=True)

    def picture(self):
        self.options.pictures.mkdir(parents=True, exist_ok=True)
        self.mrroc("robot", "show", self.name, "--postures", "1", "--picture", self.options.pictures / f"{self.name}.png")


def page(arms, options):
    lines = ["# Public arms", "",
             "Reference. Every arm below was added by one `mrroc robot add FILE.urdf --accept-guesses`, without a program. Made by",
             "`tests/robots/arms/arms.py`, which fetches the packages; none of them is part of this repository.", "",
             "KDL, MuJoCo: the worst difference of 10,000 random postures to the chain, in m or rad. Nearby: of 10,000 poses,",
             "those that the inverse finds from a posture within 0.1 rad or m; median and largest processor time in µs. Home: the",
             "same for 20,000 poses from home, as a motion in joint space asks, within the limits always. Branches: of these",
             "20,000 postures, those among the branches of their poses (seven axes: poses reached). Guessed: axes whose",
             "acceleration and jerk, links whose inertia. Demo: the beginning of the hash of the steps, equal in all runs.", "",
             "| arm | package | axes | inverse | KDL | MuJoCo | nearby | µs | home | µs | branches | guessed | demo |",
             "|---|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for arm in arms:
        name = f"[{arm.name}]({os.path.relpath(options.pictures / (arm.name + '.png'), options.table.parent)})"
        inverse = arm.inverse.replace("closed form: ", "").replace(", within the limits", "")
        lines.append(f"| {name} | {arm.package} {arm.version} | {arm.axes} | {inverse} | {arm.kdl} | {arm.mujoco} | {arm.near[0]}"
                     f" | {arm.near[1]}, {arm.near[2]} | {arm.home[0]} | {arm.home[1]}, {arm.home[2]} | {arm.branches}"
                     f" | {arm.axes} axes, {arm.bodies} links | `{arm.hash[:8]}` |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mrroc", type=pathlib.Path)
    parser.add_argument("cache", type=pathlib.Path)
    parser.add_argument("--only", nargs="+", default=[])
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--postures", default="10000", help="of the checks; a table has the default")
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--controllers", action="store_true", help="only arms with a controller that is simulated: press with it, on the real clock and in lockstep")
    parser.add_argument("--clocks", nargs="+", choices=("real", "lockstep"), default=["real", "lockstep"], help="of --controllers")
    parser.add_argument("--pictures", type=pathlib.Path, default=pathlib.Path("docs/pictures/arms"))
    options = parser.parse_args()
    options.mrroc, options.cache = options.mrroc.resolve(), options.cache.resolve()
    os.environ["MRROC"] = str(options.mrroc)
    description = tomllib.loads((pathlib.Path(__file__).parent / "arms.toml").read_text(encoding="utf-8"))
    arms, failures = [], 0
    for entry in description["arms"]:
        if (options.only and entry["name"] not in options.only) or (options.controllers and not entry.get("controller")):
            continue
        arm = Arm(entry, description["packages"], options)
        try:
            for step in (arm.add, arm.press) if options.controllers else (arm.add, arm.check, arm.demo, arm.demo_by_torques, arm.press):
                step()
            if options.table:
                arm.picture()
        except (RuntimeError, subprocess.TimeoutExpired) as error:
            print(f"{arm.name}: {error}", flush=True)
            failures += 1
            continue
        if options.controllers:
            arms.append(arm)
            continue
        print(f"{arm.name}: {arm.axes} axes, {arm.inverse}, KDL {arm.kdl}, MuJoCo {arm.mujoco}, {arm.near[1]} us, branches {arm.branches}, demo {arm.hash[:8]}", flush=True)
        arms.append(arm)
    if options.table and not failures:
        options.table.write_text(page(arms, options), encoding="utf-8")
    print(f"{len(arms)} arms, {failures} failures")
    return 1 if failures or not arms else 0


if __name__ == "__main__":
    sys.exit(main())
