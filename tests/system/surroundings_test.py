"""Deployments run under the conditions of users and services: as users of every kind, with and
without a home, on loopback devices of every kind, with closed standard files. As an ordinary user and as root.

surroundings_test.py BUILD_FOLDER SOURCE_FOLDER
"""

import contextlib
import itertools
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

BUILD, SOURCE = (pathlib.Path(folder).resolve() for folder in sys.argv[1:3])
MRROC = str(BUILD / "bin/mrroc")
STRANGER = 54321  # a user that is in no file of this machine
PATIENCE = 240
os.environ["PATH"] += ":/usr/sbin:/sbin"

ARM = """
[robots.arm]
type = "irb6"
hardware = "loopback"
program = "{build}/tests/faulty_ecp"
"""
HOST = """
[hosts.cell]
address = "127.0.0.1"
command = ["env"]
"""


def deployment(folder, clock="lockstep", more="", robot="", name="robot_type"):
    """A task that ends at once with its own error: exit code 1."""
    file = folder / f"{name}.toml"
    general = f'[deployment]\nname = "{name}"\nclock = "{clock}"\nstart_timeout = 60\nheartbeat_timeout = 5\nlink_timeout = 5\n'
    file.write_text(general + more + ARM.format(build=BUILD) + robot, encoding="utf-8")
    return str(file)


def without_capabilities():
    return ["setpriv", "--inh-caps=-all", "--bounding-set=-all", "--"]


def as_nobody_known():
    """A user without an entry in /etc/passwd and without capabilities."""
    return ["unshare", "--user", f"--map-user={STRANGER}", f"--map-group={STRANGER}", "--"]


def in_own_network(script):
    return ["unshare", "--user", "--map-root-user", "--net", "--", "sh", "-c", script + ' && exec "$@"', "sh"]


def run(command, **options):
    options.setdefault("timeout", PATIENCE)
    options.setdefault("stdin", subprocess.DEVNULL)
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False, **options)


def other_users():
    """Commands that change to another user with access to the build folder; for root only."""
    if os.geteuid() != 0:
        return []
    users = [["setpriv", f"--reuid={user}", f"--regid={user}", "--clear-groups", "--inh-caps=-all", "--bounding-set=-all", "--"]
             for user in (65534, STRANGER)]
    return [user for user in users if run([*user, MRROC, "--help"]).returncode == 0]


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="mrroc_surroundings_"))
        self.folder.chmod(0o777)
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def expect(self, command, code, text="", **options):
        options.setdefault("cwd", self.folder)
        done = run(command, **options)
        self.assertEqual(done.returncode, code, f"{command}\n{done.stdout}{done.stderr}")
        self.assertIn(text, done.stdout + done.stderr)
        return done


class Users(Case):
    """A run needs neither root nor a capability."""

    def users(self):
        return [without_capabilities() if os.geteuid() == 0 else [], as_nobody_known(), *other_users()]

    def test_every_clock(self):
        for user, clock in itertools.product(self.users(), ("lockstep", "paced", "real")):
            with self.subTest(user=user, clock=clock):
                self.expect([*user, MRROC, "run", deployment(self.folder, clock), "--black-box", ""], 1, "robot_type")

    def test_keys_and_two_hosts(self):
        for number, user in enumerate(self.users()):
            with self.subTest(user=user):
                keys = self.folder / f"keys{number}"
                self.expect([*user, MRROC, "keys", str(keys)], 0)
                network = f'[network]\nkeys = "{keys}"\n'
                self.expect([*user, MRROC, "run", deployment(self.folder, more=network), "--black-box", ""], 1)
                hosts = deployment(self.folder, "real", network + HOST, 'host = "cell"\n')
                self.expect([*user, MRROC, "run", hosts, "--black-box", ""], 1, "robot_type")

    def test_physics_in_a_container(self):
        """As with `docker run --user`: no entry in /etc/passwd, no home, a read-only folder."""
        kept = ("PATH", "ASAN_OPTIONS", "LSAN_OPTIONS", "TSAN_OPTIONS")
        environment = {name: os.environ[name] for name in kept if name in os.environ}
        press = str(SOURCE / "tasks/press/press.toml")
        self.expect([*as_nobody_known(), MRROC, "run", press, "--black-box", ""], 0, "press succeeded", cwd="/", env=environment)

    def test_homes(self):
        for home in ({}, {"HOME": ""}, {"HOME": "/nonexistent"}, {"HOME": "/proc"}, {"HOME": "/", "XDG_RUNTIME_DIR": "/nonexistent"}):
            with self.subTest(home=home):
                environment = {name: value for name, value in os.environ.items() if name not in ("HOME", "XDG_RUNTIME_DIR", "USER")}
                self.expect([*as_nobody_known(), MRROC, "run", deployment(self.folder), "--black-box", ""], 1, "robot_type",
                            env={**environment, **home})

    def test_limits_of_locked_memory(self):
        """No limit, one that is sufficient only at first, and one that may be raised: the run behaves as without a limit."""
        hard = resource.getrlimit(resource.RLIMIT_MEMLOCK)[1]
        limits = [(0, 0), (64 << 10, 64 << 10), (0, hard), (100 << 20, 100 << 20), (500 << 20, 500 << 20), (0, resource.RLIM_INFINITY)]
        may_raise = run(["prlimit", "--memlock=unlimited", "true"]).returncode == 0  # CAP_SYS_RESOURCE
        tested = [limit for limit in limits if may_raise or hard == resource.RLIM_INFINITY or 0 <= limit[1] <= hard]
        self.assertGreater(len(tested), 2)
        for soft, most in tested:
            with self.subTest(soft=soft, most=most):
                user = without_capabilities() if os.geteuid() == 0 else []
                limit = [f"--memlock={soft}:{'unlimited' if most == resource.RLIM_INFINITY else most}"]
                command = ["prlimit", *limit, *user, MRROC, "run", deployment(self.folder, "real"), "--black-box", ""]
                self.expect(command, 1, "robot_type")

    def test_two_users_at_once(self):
        users = (self.users() + self.users())[-3:]
        file = deployment(self.folder)  # one file for all, written before the first of them reads it
        runs = [subprocess.Popen([*user, MRROC, "run", file, "--black-box", ""], cwd=self.folder,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) for user in users]
        for one in runs:
            output, _ = one.communicate(timeout=PATIENCE)
            self.assertEqual(one.returncode, 1, output)


class Networks(Case):
    """As root of a user namespace, in a separate network."""

    def test_loopback_of_every_kind(self):
        for script in ("ip link set lo up", "ip link set lo up multicast on", "ip link set lo up mtu 576 multicast on",
                       "ip link set lo up && ip address add 10.9.9.9/32 dev lo",
                       "ip address add 10.9.9.9/32 dev lo && ip link set lo up multicast on",
                       "ip link set lo up allmulticast on multicast on"):
            with self.subTest(script=script):
                self.expect([*in_own_network(script), MRROC, "run", deployment(self.folder), "--black-box", ""], 1, "robot_type")

    def test_cards(self):
        card = "ip link set lo up && ip link add card0 type veth peer name card1 && ip link set card1 up && ip link set card0 up && "
        for name, script in (("card0", "ip address add 10.0.0.2/24 dev card0"),
                             ("card0", "ip address add 10.0.0.2/24 dev card0 && ip link set card0 multicast off"),
                             ("10.0.1.2", "ip address add 10.0.0.2/24 dev card0 && ip address add 10.0.1.2/24 dev card0"),
                             ("card0", "ip address add 10.0.0.2/24 dev card0 && ip link set card0 mtu 576"),
                             ("card0", "ip address add 10.0.0.2/24 dev card0 && ip link set card0 mtu 9000"),
                             ("card0", "ip address add 10.8.0.2 peer 10.8.0.1 dev card0 && ip link set card0 arp off multicast off")):
            with self.subTest(script=script):
                file = deployment(self.folder, more=f'[network]\ninterface = "{name}"\nsecurity = false\n')
                self.expect([*in_own_network(card + script), MRROC, "run", file, "--black-box", ""], 1, "robot_type")
        if os.geteuid() == 0 and os.access("/dev/net/tun", os.W_OK):  # tunnels need root and the device
            script = ("ip link set lo up && ip tuntap add dev tun0 mode tun && ip address add 10.8.0.2 peer 10.8.0.1 dev tun0 && "
                      "ip link set tun0 up multicast off")
            file = deployment(self.folder, more='[network]\ninterface = "tun0"\nsecurity = false\n')
            network = ["unshare", "--net", "--", "sh", "-c", script + ' && exec "$@"', "sh"]
            self.expect([*network, MRROC, "run", file, "--black-box", ""], 1, "robot_type")

    def test_interfaces_that_cannot_be_used(self):
        card = "ip link set lo up && ip link add card0 type veth peer name card1 && "
        for name, script, text in (("", "true", "'lo' is down"), ("lo", "true", "'lo' is down"),
                                   ("card0", card + "ip address add 10.0.0.2/24 dev card0", "'card0' is down"),
                                   ("10.0.0.2", card + "ip address add 10.0.0.2/24 dev card0", "'card0' is down"),
                                   ("card0", card + "ip link set card0 up", "'card0' has no IPv4 address"),
                                   ("card7", card + "true", "'card7'")):
            with self.subTest(name=name):
                network = f'[network]\ninterface = "{name}"\nsecurity = false\n' if name else ""
                file = deployment(self.folder, more=network)
                self.expect([*in_own_network(script), MRROC, "run", file, "--black-box", ""], 2, text)


SUBSETS = [subset for count in (1, 2, 3) for subset in itertools.combinations((0, 1, 2), count)]


LOOK = """
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
__attribute__((destructor)) static void check(void) {
  FILE* seen = fopen(getenv("SEEN"), "a");
  for (int fd = 0; fd < 3; ++fd) {
    char link[20], name[200] = "";
    sprintf(link, "/proc/self/fd/%d", fd);
    if (readlink(link, name, sizeof name - 1) < 0) sprintf(name, "closed");
    fprintf(seen, "%s\\n", name);
  }
  fclose(seen);
}
"""


def closing(subset, command):
    """The command with these descriptors closed."""
    return ["sh", "-c", 'exec "$@" ' + " ".join("<&-" if fd == 0 else f"{fd}>&-" for fd in subset), "sh", *command]


class StandardFiles(Case):
    """With any of the descriptors 0 to 2 closed as with /dev/null."""

    def same(self, subset, command, **options):
        options.setdefault("cwd", self.folder)
        given = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "stdin": subprocess.DEVNULL, "timeout": PATIENCE}
        done = subprocess.run(closing(subset, command), check=False, **given, **options)
        expected = subprocess.run(command, check=False, **given, **options)
        self.assertEqual(done.returncode, expected.returncode, (subset, command))

    def test_every_program(self):
        """At its end each program has /dev/null in place of a closed file: a preloaded library checks it."""
        (self.folder / "look.c").write_text(LOOK, encoding="ascii")
        look = self.folder / "look.so"
        subprocess.run(["cc", "-shared", "-fPIC", "-o", look, self.folder / "look.c"], check=True)
        programs = sorted(path for path in (BUILD / "bin").iterdir() if os.access(path, os.X_OK) and path.is_file())
        self.assertGreater(len(programs), 9)
        for program in programs:
            seen = self.folder / program.name
            environment = {**os.environ, "SEEN": str(seen), "ASAN_OPTIONS": "verify_asan_link_order=0"}
            subsets = SUBSETS if program.name == "mrroc" else [(0,), (1, 2), (0, 1, 2)]
            expected = run([str(program), "--help"]).returncode
            for subset in subsets:
                done = run(closing(subset, ["env", f"LD_PRELOAD={look}", str(program), "--help"]), env=environment)
                self.assertEqual(done.returncode, expected, (program, subset))
            files = seen.read_text(encoding="ascii").split()
            self.assertEqual(len(files), 3 * len(subsets), program)
            for (subset, fd), file in zip(itertools.product(subsets, range(3)), files):
                self.assertTrue(file.startswith("/dev/null" if fd in subset or fd == 0 else "pipe:"), (program, subset, fd, file))

    def test_verbs(self):
        recording = self.folder / "run.mcap"
        file = deployment(self.folder)
        run([MRROC, "run", file, "--black-box", "", "--record", str(recording)], cwd=self.folder)
        for subset in SUBSETS:
            for verb in (["run", file, "--check"], ["trace", "hash", str(recording)], ["trace", "check", str(recording)], ["agent"]):
                self.same(subset, [MRROC, *verb])
            keys = self.folder / ("keys" + "".join(map(str, subset)))
            code = subprocess.run(closing(subset, [MRROC, "keys", str(keys)]), check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
            self.assertEqual((code, (keys / "identity.pem").exists()), (0, True))

    def test_runs(self):
        for subset, clock in [*((subset, "lockstep") for subset in SUBSETS), ((0,), "real"), ((0, 1, 2), "real"), ((0, 1, 2), "paced")]:
            with self.subTest(subset=subset, clock=clock):
                command = closing(subset, [MRROC, "run", deployment(self.folder, clock), "--black-box", ""])
                done = run(command, cwd=self.folder)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)

    def test_processes_of_a_run(self):
        """With any files closed, every process of the run has the three files, and none of them is a file of the framework."""
        for subset in SUBSETS:
            with self.subTest(subset=subset):
                file = deployment(self.folder, "real", name="never")
                runner = subprocess.Popen(closing(subset, [MRROC, "run", file, "--black-box", ""]), cwd=self.folder, stdin=subprocess.DEVNULL,
                                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                try:
                    deadline = time.monotonic() + PATIENCE
                    while len(processes := family(runner.pid)) < 4 and time.monotonic() < deadline:
                        time.sleep(0.01)
                    self.assertGreaterEqual(len(processes), 4)  # the runner, MP, ECP and EDP
                    for pid, fd in itertools.product(processes, range(3)):
                        target = os.readlink(f"/proc/{pid}/fd/{fd}")
                        self.assertTrue(target == "/dev/null" or target.startswith("pipe:"), (pid, fd, target))
                    for fd in subset:
                        self.assertEqual(os.readlink(f"/proc/{runner.pid}/fd/{fd}"), "/dev/null")
                finally:
                    runner.send_signal(signal.SIGINT)
                    with contextlib.suppress(subprocess.TimeoutExpired):
                        runner.communicate(timeout=60)
                    runner.kill()
                self.assertEqual(runner.wait(), 5)


def family(pid):
    """The process and those of its children that already execute their own program."""
    try:
        children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="ascii").split()
    except FileNotFoundError:
        return []
    programs = [int(child) for child in children if "--name" in pathlib.Path(f"/proc/{child}/cmdline").read_text(encoding="utf-8")]
    return [pid, *programs]


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
