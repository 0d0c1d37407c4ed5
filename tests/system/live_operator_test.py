"""A run that is operated while it runs: from other terminals, at its own terminal, through its socket.

live_operator_test.py BUILD_FOLDER SOURCE_FOLDER [LiveOperator.TEST ...]
"""

import contextlib
import json
import os
import pathlib
import pty
import random
import select
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

BUILD, SOURCE = (pathlib.Path(folder).resolve() for folder in sys.argv[1:3])
MRROC = str(BUILD / "bin/mrroc")
PRESS = str(SOURCE / "tasks/press/press.toml")
TIMEOUT = 240
STOPPED = 5
HOME = [0.0, -1.747780928, 0.4768189, -0.299834299, 4.71238898, 1.57079633]  # of robots/irb6/irb6.toml
MESSAGES = 1_000_000 if os.environ.get("MRROC_TEST_THOROUGH") else 200_000
MACROSTEP, VALIDITY, BRAKING = 10, 100, 150  # ticks of 2 ms: N, 0.2 s, 0.3 rad/s at 1 rad/s^2
MOVES, RESTS = 2e-3, 1e-2  # rad/s; at rest the regulator keeps the joint below
SEEDS = 20 if os.environ.get("MRROC_TEST_THOROUGH") else 6


def output_of(*arguments, code=0):
    done = subprocess.run([MRROC, *arguments], capture_output=True, text=True, timeout=TIMEOUT, check=False)
    assert done.returncode == code, (arguments, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


def refusal_of(*arguments):
    """Why an order is refused, once the drives are on."""
    deadline = time.monotonic() + TIMEOUT
    while "being switched on" in (answer := output_of(*arguments, code=1)) and time.monotonic() < deadline:
        time.sleep(0.1)
    return answer


def robot_state(robot):
    """Its newest state, as watchers see it."""
    with subprocess.Popen([MRROC, "echo", "--of", "robots", "--json"], stdout=subprocess.PIPE, text=True) as echo:
        for line in echo.stdout:
            event = json.loads(line)
            if event.get("event") == "robot" and event["name"] == robot:
                echo.kill()
                return event
    raise AssertionError(f"no state of {robot}")


def steps_of(recording):
    """The steps of a recording, as `mrroc trace cat` prints them, each with its time."""
    return {line for line in output_of("trace", "cat", recording).splitlines() if '"mrroc_msgs/msg/Step"' in line}


class LiveRun:
    """`mrroc run` with a runtime folder of its own."""

    def __init__(self, folder, *arguments, file=PRESS, **options):
        self.folder = pathlib.Path(folder)
        self.out = open(self.folder / "out", "w+", encoding="utf-8")
        self.command = subprocess.Popen([MRROC, "run", file, *arguments], stdin=subprocess.DEVNULL, stdout=self.out,
                                        stderr=self.out, **options)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.command.poll() is None:
            self.command.send_signal(signal.SIGINT)
            self.command.send_signal(signal.SIGINT)
        self.command.wait(TIMEOUT)
        self.out.close()

    def text(self):
        return (self.folder / "out").read_text(encoding="utf-8")

    def end(self):
        return self.command.wait(TIMEOUT)

    def state(self):
        return json.loads(output_of("status", "--json"))

    def await_state(self, holds, what):
        deadline = time.monotonic() + TIMEOUT
        while time.monotonic() < deadline:
            assert self.command.poll() is None, self.text()
            with contextlib.suppress(AssertionError):
                state = self.state()
                if holds(state):
                    return state
            time.sleep(0.02)
        raise AssertionError(f"never {what}: {self.text()}")

    def pass_ticks(self, ticks):
        """Waits by the run's clock: on a busy machine it is slower than the wall's."""
        begin = self.state()["tick"]
        self.await_state(lambda state: state["tick"] >= begin + ticks, f"{ticks} ticks later")

    def await_task(self, task):
        return self.await_state(lambda state: state["task"] == task, task)


class Client:
    """A connection to the operator socket of the only run."""

    def __init__(self, folder):
        path, = (pathlib.Path(folder) / "mrroc").glob("*.sock")
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(str(path))
        self.lines = self.socket.makefile("r", encoding="utf-8")
        self.greeting = json.loads(self.lines.readline())

    def request(self, **request):
        self.socket.sendall((json.dumps(request) + "\n").encode())
        while True:
            line = self.lines.readline()
            if not line:
                return None
            reply = json.loads(line)
            if "ok" in reply:
                return reply

    def close(self):
        self.lines.close()
        self.socket.close()


def missed_ticks(state):
    return sum(process["missed_ticks"] + process["late_commands"] for process in state["processes"])


def memory_of(pid):
    """Resident, kB."""
    status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    return int(status.split("VmRSS:")[1].split()[0])


class Flood:
    """Clients that send wrong requests as fast as the run reads them, and read its refusals."""

    MESSAGES = b'{"verb":"frobnicate"}\nno JSON\n{"verb":"jog","robot":"leg"}\n[1, 2]\n{"verb":"pause","id":"x"}\n' * 40

    def __init__(self, folder, clients):
        path, = (pathlib.Path(folder) / "mrroc").glob("*.sock")
        self.answered = -clients  # the greetings are no answers
        self.rest = {}  # by socket: what is to be sent next
        for _ in range(clients):
            client = socket.socket(socket.AF_UNIX)
            client.connect(str(path))
            client.setblocking(False)
            self.rest[client] = self.MESSAGES

    @property
    def connected(self):
        return len(self.rest) > 0

    def exchange(self):
        readable, writable, _ = select.select(list(self.rest), list(self.rest), [], 1)
        for client in readable:
            try:
                received = client.recv(1 << 18)
            except ConnectionError:
                received = b""
            self.answered += received.count(b"\n")
            if not received:
                self.close(client)
        for client in writable:
            with contextlib.suppress(BlockingIOError):
                try:
                    if client in self.rest:
                        self.rest[client] = self.rest[client][client.send(self.rest[client]):] or self.MESSAGES
                except ConnectionError:
                    self.close(client)

    def close(self, client):
        client.close()
        del self.rest[client]


# a client that jogs twenty times a second over one connection, as a panel does
JOGGER = """
import pathlib, socket, sys, time
path, = (pathlib.Path(sys.argv[1]) / "mrroc").glob("*.sock")
client = socket.socket(socket.AF_UNIX)
client.connect(str(path))
while True:
    client.sendall(b'{"verb":"jog","robot":"arm","axis":"column","velocity":0.3}\\n')
    client.recv(65536)
    time.sleep(0.05)
"""


class LiveOperator(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        os.environ["MRROC_RUNTIME_DIR"] = f"{self.folder}/mrroc"
        self.recording, self.noted = f"{self.folder}/live.mcap", f"{self.folder}/noted.toml"

    def tearDown(self):
        shutil.rmtree(self.folder)

    def expect_same_run_in_lockstep(self, exit_code):
        again = f"{self.folder}/again.mcap"
        output_of("run", PRESS, "--hold", "--clock", "lockstep", "--events", self.noted, "--record", again, "--quiet",
                  "--black-box=", code=exit_code)
        self.assertEqual(output_of("trace", "hash", self.recording), output_of("trace", "hash", again))
        output_of("trace", "check", self.recording)

    def noting(self, black_boxes=""):
        return ["--clock", "paced", "--note-events", self.noted, "--record", self.recording, f"--black-box={black_boxes}"]

    def test_run_is_held_started_paused_resumed_and_stopped_from_another_terminal(self):
        with LiveRun(self.folder, "--hold", *self.noting()) as run:
            run.await_task("held")
            self.assertIn("'start' before", output_of("pause", code=1))
            self.assertIn("press", output_of("list"))
            output_of("start", "press")
            run.await_state(lambda state: any(p["instruction"] == 2 for p in state["processes"]), "in its second motion")
            output_of("pause")
            self.assertEqual(run.state()["task"], "paused")
            self.assertIn("did you mean 'resume'?", output_of("resum", code=2))
            output_of("resume", "press")
            output_of("stop")
            self.assertEqual(run.end(), STOPPED)
        self.assertIn("no deployment", output_of("list"))
        self.expect_same_run_in_lockstep(STOPPED)

    def test_last_steps_are_recorded_while_the_task_runs(self):
        elsewhere = f"{self.folder}/elsewhere"
        os.mkdir(elsewhere)
        with LiveRun(self.folder, "--hold", *self.noting(f"{self.folder}/boxes"), cwd=self.folder) as run:
            run.await_task("held")
            self.assertIn("no task on this machine has made a step", output_of("record", "early.mcap", code=1))
            output_of("start")
            run.await_state(lambda state: any(p["instruction"] == 2 for p in state["processes"]), "in motion")
            holder = Client(self.folder)
            self.assertTrue(holder.request(verb="command")["ok"])
            command = [MRROC, "record", "client.mcap"]
            done = subprocess.run(command, cwd=elsewhere, capture_output=True, text=True, timeout=TIMEOUT, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(f"black box: {elsewhere}/client.mcap [tick ", done.stdout)
            reply = holder.request(verb="record", file="socket.mcap")
            self.assertIn(f"steps of arm; black box: {self.folder}/socket.mcap", reply["text"])
            reply = holder.request(verb="record", file="socket.mcap")
            self.assertEqual((reply["ok"], reply["reason"]), (False, "invalid_argument"))
            self.assertIn("exists", reply["text"])
            self.assertIn("No such file", output_of("record", f"{elsewhere}/no/such.mcap", code=2))
            holder.close()
            self.assertEqual(run.end(), 0)
            self.assertIn("record by holder", run.text().replace("python3", "holder"))
        for file in (f"{elsewhere}/client.mcap", f"{self.folder}/socket.mcap"):
            self.assertIn("rules hold", output_of("trace", "check", file))
            steps = steps_of(file)
            self.assertGreater(len(steps), 10)
            self.assertLessEqual(steps, steps_of(self.recording))
        self.expect_same_run_in_lockstep(0)

    def test_speed_is_changed_during_a_motion(self):
        with LiveRun(self.folder, *self.noting()) as run:
            run.await_state(lambda state: any(p["instruction"] == 2 for p in state["processes"]), "in motion")
            for wrong in ("0", "101", "fast"):
                self.assertIn("expected percent from 1 to 100", output_of("speed", wrong, code=2))
            output_of("speed", "30")
            self.assertEqual(run.state()["speed"], 0.3)
            run.pass_ticks(200)
            output_of("pause")
            run.pass_ticks(100)
            output_of("resume")
            output_of("speed", "70")
            run.pass_ticks(100)
            output_of("speed", "100")
            self.assertEqual(run.end(), 0)
        self.expect_same_run_in_lockstep(0)

    def test_run_that_is_held_can_be_stopped(self):
        with LiveRun(self.folder, "--hold", *self.noting()) as run:
            run.await_task("held")
            output_of("stop")
            self.assertEqual(run.end(), STOPPED)
        self.expect_same_run_in_lockstep(STOPPED)

    def test_emergency_stop_of_another_terminal_ends_the_task_with_its_error(self):
        with LiveRun(self.folder, *self.noting()) as run:
            run.await_state(lambda state: any(p["instruction"] == 2 for p in state["processes"]), "in motion")
            output_of("estop")
            code = run.end()
        self.assertEqual(code, 3)
        self.expect_same_run_in_lockstep(code)

    def test_echo_shows_changes_until_the_end(self):
        with LiveRun(self.folder, "--hold", "--clock", "paced") as run:  # lockstep has passed states before they are sent
            run.await_task("held")
            echo = subprocess.Popen([MRROC, "echo", "--json"], stdout=subprocess.PIPE, text=True)
            self.addCleanup(echo.stdout.close)
            run.await_state(lambda state: True, "answering")
            time.sleep(0.2)
            output_of("start")
            events = [json.loads(line) for line in echo.stdout]
            self.assertEqual(echo.wait(TIMEOUT), 0)
            self.assertEqual(run.end(), 0)
        kinds = [event["event"] for event in events]
        self.assertEqual(kinds[-1], "end")
        self.assertEqual(events[-1]["exit_code"], 0)
        self.assertIn("command", kinds)
        self.assertTrue(any(event["event"] == "process" and event["activity"] == "ToolVelocity" for event in events))

    def test_robot_of_a_paused_task_is_moved_aside_and_the_task_continues(self):
        with LiveRun(self.folder, *self.noting()) as run:
            run.await_state(lambda state: any(p["instruction"] == 2 for p in state["processes"]), "in motion")
            self.assertIn("the task commands the robot", output_of("step", "arm", "column", "0.1", code=1))
            output_of("pause")
            run.pass_ticks(300)
            output_of("step", "arm", "column", "-0.2")
            for _ in range(5):
                output_of("jog", "arm", "z", "0.02", "--in", "base")
            output_of("resume")
            self.assertEqual(run.end(), 0)
        self.expect_same_run_in_lockstep(0)

    def test_watchers_see_robots_and_readings_and_change_nothing(self):
        plain, watched = f"{self.folder}/plain.mcap", f"{self.folder}/watched.mcap"
        output_of("run", PRESS, "--hold", "--events", self.write_start(), "--clock", "lockstep", "--quiet", "--record", plain)
        with LiveRun(self.folder, "--hold", "--events", self.write_start(), "--clock", "lockstep", "--record", watched) as run:
            while not list((pathlib.Path(self.folder) / "mrroc").glob("*.sock")):
                time.sleep(0.001)
            watchers = [subprocess.Popen([MRROC, "echo", "--of", of, "--json"], stdout=subprocess.PIPE, text=True)
                        for of in ("all", "robots", "readings", "changes")]
            events = [[json.loads(line) for line in watcher.stdout] for watcher in watchers]
            for watcher in watchers:
                watcher.stdout.close()
                self.assertEqual(watcher.wait(TIMEOUT), 0)
            self.assertEqual(run.end(), 0)
        self.assertEqual(output_of("trace", "hash", plain), output_of("trace", "hash", watched))
        kinds = [{event["event"] for event in seen} for seen in events]
        for seen, robots, readings in zip(kinds, (True, True, False, False), (True, False, True, False)):
            self.assertEqual("robot" in seen, robots)
            self.assertEqual("reading" in seen, readings)
        robot = next(event for event in events[0] if event["event"] == "robot")
        self.assertEqual((robot["name"], len(robot["joints"]), len(robot["pose"])), ("arm", 6, 7))
        reading = next(event for event in events[0] if event["event"] == "reading" and event["name"] == "gate")
        self.assertEqual(list(reading["values"]), ["distance", "detected"])

    def write_start(self):
        """The task starts after 80 s of simulated time: watchers have joined."""
        file = pathlib.Path(self.folder) / "start.toml"
        file.write_text('[[events]]\ntick = 40000\ncommand = "start"\n', encoding="utf-8")
        return str(file)

    def test_keys_and_typed_verbs_at_the_terminal(self):
        terminal, slave = pty.openpty()
        arguments = self.noting(f"{self.folder}/boxes")
        run = subprocess.Popen([MRROC, "run", PRESS, *arguments], stdin=slave, stdout=slave, stderr=slave,
                               start_new_session=True, preexec_fn=lambda: __import__("fcntl").ioctl(0, 0x540E, 0))
        os.close(slave)
        shown = ""

        def await_shown(text):
            nonlocal shown
            deadline = time.monotonic() + TIMEOUT
            while text not in shown and time.monotonic() < deadline:
                if select.select([terminal], [], [], 0.1)[0]:
                    shown += os.read(terminal, 65536).decode(errors="replace")
            self.assertIn(text, shown)
            shown = shown[shown.index(text) + len(text):]

        await_shown("JointLine")
        os.write(terminal, b" ")
        await_shown("pause: the robots come to rest and hold")
        os.write(terminal, b"statsu\r")
        await_shown("did you mean 'status'?")
        os.write(terminal, b"sta")
        await_shown("> sta")
        os.write(terminal, f"\x15record {self.folder}/typed.mcap\r".encode())
        await_shown("steps of arm; black box:")
        self.assertIn("rules hold", output_of("trace", "check", f"{self.folder}/typed.mcap"))
        os.write(terminal, b"help\r")
        await_shown("Bring the robots to rest and end the run")
        os.write(terminal, b" ")
        await_shown("resume: the task continues")
        os.write(terminal, b"stop\r")
        await_shown("stop: the robots come to rest")
        with contextlib.suppress(OSError):  # the end of the terminal
            while os.read(terminal, 65536):
                pass
        self.assertEqual(run.wait(TIMEOUT), STOPPED)
        os.close(terminal)
        self.expect_same_run_in_lockstep(STOPPED)

    def test_a_flood_of_messages_and_a_client_that_never_reads_change_nothing(self):
        with LiveRun(self.folder, "--hold", *self.noting()) as run:
            run.await_task("held")
            deaf = Client(self.folder)
            deaf.socket.sendall(b'{"verb":"echo","of":"all"}\n')
            before = missed_ticks(run.state()), memory_of(run.command.pid)
            flood = Flood(self.folder, clients=50)
            largest = 0
            while flood.answered < MESSAGES:
                flood.exchange()
                largest = max(largest, memory_of(run.command.pid))
            after = missed_ticks(run.state())
            output_of("start")
            while flood.connected:  # until the end of the run
                flood.exchange()
            self.assertEqual(run.end(), 0)
            deaf.close()
        print(f"{flood.answered} messages answered, memory of the runner {before[1]} kB, at most {largest} kB", flush=True)
        self.assertEqual(after, before[0])
        self.assertLess(largest, before[1] + 40_000, "kB")
        self.expect_same_run_in_lockstep(0)

    def test_robot_is_jogged_sent_to_a_posture_and_held_before_the_task_starts(self):
        with LiveRun(self.folder, "--hold", *self.noting()) as run:
            run.await_task("held")
            output_of("jog", "arm", "column", "0.2")
            run.pass_ticks(300)
            self.assertIn("did you mean 'column'?", output_of("jog", "arm", "colum", "0.2", code=2))
            self.assertIn("out of range", output_of("jog", "arm", "column", "9", code=2))
            output_of("step", "arm", "z", "0.02", "--in", "base")
            output_of("step", "arm", "rz", "-0.1", "--in", "tool")
            output_of("jog", "arm", "lower_arm", "3", "--in", "motors")
            run.pass_ticks(300)
            going = subprocess.Popen([MRROC, "go", "arm", "raised"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            run.pass_ticks(150)
            output_of("hold", "arm")
            self.assertIn("ended by 'hold'", going.communicate(timeout=TIMEOUT)[0])
            run.pass_ticks(300)
            output_of("go", "arm", "raised")
            output_of("go", "arm", "home")
            with_tool = robot_state("arm")["pose"]
            output_of("tool", "arm", "flange")
            run.pass_ticks(100)
            flange = robot_state("arm")["pose"]
            self.assertAlmostEqual(sum((a - b) ** 2 for a, b in zip(with_tool[:3], flange[:3])) ** 0.5, 0.25, places=4)
            output_of("step", "arm", "rx", "0.05", "--in", "tool")
            self.assertIn("did you mean 'standard'?", output_of("tool", "arm", "standart", code=2))
            output_of("tool", "arm", "standard")
            output_of("go", "arm", "home")
            output_of("output", "arm", "3", "1")
            output_of("start")
            self.assertIn("the task commands the robot", output_of("jog", "arm", "column", "0.2", code=1))
            self.assertEqual(run.end(), 0)
        self.expect_same_run_in_lockstep(0)

    def test_robot_that_is_not_synchronised_takes_motor_jogs_until_it_is(self):
        text = pathlib.Path(PRESS).read_text(encoding="utf-8")
        text = text.replace('"press.xml"', f'"{SOURCE}/tasks/press/press.xml"')
        text = text.replace("[robots.arm]", "[robots.arm]\nsynchronised = false")
        file = pathlib.Path(self.folder) / "unsynchronised.toml"
        file.write_text(text, encoding="utf-8")
        with LiveRun(self.folder, "--hold", "--clock", "lockstep", "--black-box=", file=str(file)) as run:
            run.await_task("held")
            for order in (["go", "arm", "home"], ["jog", "arm", "column", "0.1"], ["step", "arm", "z", "0.01", "--in", "tool"]):
                self.assertIn("not synchronised", output_of(*order, code=1))
            output_of("jog", "arm", "column", "3", "--in", "motors")
            run.pass_ticks(1000)
            output_of("synchronise", "arm")
            output_of("go", "arm", "home")
            output_of("start")
            self.assertEqual(run.end(), 0)

    def test_fault_of_a_robot_that_waits_is_shown_until_it_has_recovered(self):
        def fault_of(state):
            edp, = (process for process in state["processes"] if process["name"] == "arm_edp")
            return edp.get("error")

        fault = "fault edp:arm at tick 500 for 250 ticks"
        with LiveRun(self.folder, "--hold", "--clock", "paced", "--black-box=", "--inject", fault) as run:
            self.assertIsNone(fault_of(run.await_task("held")))
            shown = fault_of(run.await_state(fault_of, "faulty"))
            line, = (line for line in output_of("status").splitlines() if line.startswith("arm_edp "))
            self.assertIn(shown["detail"], line)
            self.assertIn(shown["detail"], run.text())
            run.pass_ticks(300)
            output_of("recover", "arm")
            run.await_state(lambda state: not fault_of(state), "recovered")
            output_of("start")
            run.await_task("running")
            output_of("stop")
            self.assertEqual(run.end(), STOPPED)

    def test_other_drives_and_links_with_keys_are_operated(self):
        text = pathlib.Path(PRESS).read_text(encoding="utf-8").replace('"press.xml"', f'"{SOURCE}/tasks/press/press.xml"')
        output_of("keys", f"{self.folder}/keys")
        kinds = {
            "plant_model": '[deployment]\nname = "press"\n[robots.arm]\ntype = "irb6"\nhardware = "loopback"\n',
            "bus": text.replace('"mujoco"', '"socketcan"\nsynchronised = false')
            + f'\n[robots.arm.can]\nsimulated = true\ninterface = "unix:{self.folder}/bus"\n',
            "keys": text + f'\n[network]\nkeys = "{self.folder}/keys"\n',
        }
        for kind, deployment in kinds.items():
            with self.subTest(kind):
                file = pathlib.Path(self.folder) / f"{kind}.toml"
                file.write_text(deployment, encoding="utf-8")
                with LiveRun(self.folder, "--hold", "--clock", "paced", "--black-box=", file=str(file)) as run:
                    run.await_task("held")
                    if kind == "bus":
                        self.assertIn("not synchronised", refusal_of("go", "arm", "home"))
                        output_of("jog", "arm", "column", "3", "--in", "motors")
                        run.pass_ticks(300)
                        output_of("synchronise", "arm")
                    before = robot_state("arm")["joints"]
                    output_of("jog", "arm", "column", "-0.2")
                    run.pass_ticks(300)
                    self.assertLess(robot_state("arm")["joints"][0], before[0] - 0.01, kind)
                    output_of("step", "arm", "z", "0.02", "--in", "base")
                    output_of("step", "arm", "1", "-0.05")
                    output_of("go", "arm", "home")
                    for joint, target in zip(robot_state("arm")["joints"], HOME):
                        self.assertAlmostEqual(joint, target, places=2)
                    output_of("output", "arm", "2", "1")
                    output_of("stop")
                    self.assertEqual(run.end(), STOPPED)

    def test_jog_ends_when_its_sender_is_killed(self):
        """The dead-man counts ticks in the EDP: no message says that the sender is gone."""
        motion = f"{self.folder}/motion"
        with LiveRun(self.folder, "--hold", "--motion", motion, *self.noting()) as run:
            run.await_task("held")
            for end in (signal.SIGKILL, signal.SIGSTOP):
                sender = subprocess.Popen([sys.executable, "-c", JOGGER, self.folder])
                run.pass_ticks(700)
                sender.send_signal(end)
                stopped = run.state()["tick"]
                run.await_state(lambda state: state["tick"] > stopped + 600, "a second later")
                sender.kill()
                sender.wait(TIMEOUT)
                run.await_state(lambda state: state["tick"] > stopped + 900, "at rest")
            output_of("stop")
            self.assertEqual(run.end(), STOPPED)
        self.expect_same_run_in_lockstep(STOPPED)
        jogs = [int(text.split("tick = ")[1].split()[0]) for text in pathlib.Path(self.noted).read_text().split("[[events]]")
                if '"jog"' in text]
        self.assertGreater(len(jogs), 4)
        speed = self.speed_of_column(motion)
        series = [jog for jog, before in zip(jogs, [-(1 << 60), *jogs]) if jog - before > 300]
        self.assertEqual(len(series), 2)
        for first, following in zip(series, [*series[1:], 1 << 60]):
            last = max(jog for jog in jogs if jog < following)
            self.expect_motion_soon(first, speed)
            self.expect_rest_in_time(last, speed)

    @staticmethod
    def speed_of_column(motion):
        """rad/s by tick, as the simulated joint moves."""
        speed = {}
        for line in pathlib.Path(motion).read_text(encoding="utf-8").splitlines():
            fields = line.split()
            if fields[1] == "arm":
                speed[int(fields[0])] = abs(float(fields[9]))
        return speed

    def expect_motion_soon(self, jog, speed):
        """From rest to the first motion: at most three macrosteps."""
        self.assertLess(speed[jog], MOVES)
        moves = next(tick for tick in range(jog, jog + 1000) if speed[tick] > MOVES)
        print(f"the column moves {moves - jog} ticks after the jog", flush=True)
        self.assertLessEqual(moves - jog, 3 * MACROSTEP)

    def expect_rest_in_time(self, jog, speed):
        """From the last jog to rest: the validity and the braking time of 0.3 rad/s at 1 rad/s^2, and a macrostep for the drive to settle."""
        self.assertGreater(speed[jog], 0.05)
        rests = max(tick for tick in range(jog, jog + 600) if speed[tick] > RESTS) + 1
        print(f"the column rests {rests - jog} ticks after the last jog", flush=True)
        self.assertGreater(rests - jog, VALIDITY)
        self.assertLessEqual(rests - jog, VALIDITY + BRAKING + MACROSTEP)

    def test_random_operators_keep_every_law(self):
        """Verbs at random moments by clients that come and die: every run ends as its verbs say, and is the same run in lockstep."""
        for seed in range(SEEDS):
            with self.subTest(seed=seed):
                self.operate_at_random(random.Random(seed))

    def operate_at_random(self, chance):
        stopped = False
        with LiveRun(self.folder, "--hold", *self.noting()) as run:
            run.await_task("held")
            client = Client(self.folder)
            self.assertEqual(client.request(verb="command")["ok"], True)
            self.assertTrue(client.request(verb="start")["ok"])
            verbs = ["pause", "resume", "trigger", "pause", "resume", "status", "die", "wait", "wait"]
            for _ in range(chance.randrange(6, 14)):
                verb = chance.choice(verbs)
                time.sleep(chance.random() * 0.3)
                if verb == "die":
                    client.close()  # the holder of command disappears
                    with contextlib.suppress(FileNotFoundError, ValueError, ConnectionError):
                        client = Client(self.folder)
                elif verb != "wait":
                    with contextlib.suppress(OSError, ValueError):
                        client.request(verb=verb)
            if chance.random() < 0.5:
                with contextlib.suppress(OSError, ValueError):
                    reply = client.request(verb="stop")
                    stopped = reply is not None and reply["ok"]
            else:
                with contextlib.suppress(OSError, ValueError):
                    client.request(verb="resume")
            code = run.end()
            with contextlib.suppress(OSError):
                client.close()
        self.assertEqual(code, STOPPED if stopped else 0, run.folder)
        self.expect_same_run_in_lockstep(code)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
