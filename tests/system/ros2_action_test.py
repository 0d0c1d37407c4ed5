"""The action FollowJointTrajectory of the bridge to ROS 2, used by another implementation of DDS: Cyclone DDS 11.

ros2_action_test.py BUILD_FOLDER SOURCE_FOLDER [NAME...]
"""

import pathlib
import random
import shutil
import sys
import tempfile
import time
import unittest

import ros2_action
from ros2_action import (ABORTED, CANCELED, EXECUTING, GOAL_TOLERANCE_VIOLATED, INVALID_GOAL, NO_IDENTITY,
                         OLD_HEADER_TIMESTAMP, PATH_TOLERANCE_VIOLATED, SUCCEEDED, SUCCESSFUL, UNKNOWN, ActionClient, Header,
                         Moment, Tolerance, goal_of)
from ros2_peers import DOMAIN, SOURCE, Run, enter_network
from ros2_readers import Readers
from ros2_trigger import endpoints

# the task runs Move({arm}, {}, External{arm})
EXTERNAL = SOURCE / "tasks/external/waiting.toml"
PRESS = SOURCE / "tasks/press/press.toml"
ACTION = "/arm/follow_joint_trajectory"
JOINTS = ["column", "lower_arm", "upper_arm", "wrist_pitch", "wrist_roll", "tool_roll"]
ANY_ORDER = [JOINTS[i] for i in (3, 0, 5, 1, 4, 2)]
FEEDBACK = "control_msgs::action::dds_::FollowJointTrajectory_FeedbackMessage_"
HASHES = {  # of the feedback: the first is published by ROS 2, the second computed by rosbags from control_msgs 6.8
    "jazzy": "RIHS01_80398fcb9674a79081a9906e2ccf0c804dd7cb15e22e362e606ee87186beab71",
    "kilted": "RIHS01_95618cc73912d99b9acaa17d2da5e832cb0bfdeede7534fa8ec600feca2a6c4b",
}


class Ros2Action(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.runs = []

    def tearDown(self):
        for run in self.runs:
            run.close()
        self.assertEqual(list((self.folder / "sockets").glob("trajectory-*")), [], "files of trajectories are left")
        shutil.rmtree(self.folder)

    def run_task(self, deployment, *words, table="commands = true"):
        copied = self.folder / deployment.stem
        shutil.copytree(deployment.parent, copied)
        file = copied / deployment.name
        file.write_text(file.read_text(encoding="utf-8") + f"\n[ros2]\n{table}\n", encoding="utf-8")
        run = Run(self.folder, file, *words)
        self.runs.append(run)
        run.wait_for("ros2: node")
        return run

    def run_external(self):
        """A run whose task yields the arm; its joints at present, and a client."""
        self.run_task(EXTERNAL, "--clock", "paced")
        client = ActionClient(DOMAIN, ACTION)
        return client, self.positions()

    def positions(self):
        readers = Readers({"/joint_states": ("sensor_msgs/msg/JointState", {})})
        end = time.monotonic() + 60
        while (state := readers.read(timeout=0.1).get("/joint_states")) is None:
            self.assertLess(time.monotonic(), end, "no joint_states")
        return dict(zip(state.name, state.position))

    def start(self, client, goal):
        """Starts a goal as soon as the task yields the robot."""
        end = time.monotonic() + 60
        while True:
            accepted, identity, result = client.start(goal)
            if accepted:
                return identity, result
            self.assertLess(time.monotonic(), end, "no goal is accepted")
            time.sleep(0.1)

    @staticmethod
    def path(now, change, seconds, **fields):
        """A trajectory of five points which moves the first axis by `change` (rad), in another order than that of the axes."""
        goal = [(seconds * i / 5, [now[name] + (change * i / 5 if name == JOINTS[0] else 0) for name in ANY_ORDER]) for i in range(1, 6)]
        return goal_of(ANY_ORDER, goal, **fields)

    def test_a_goal_is_followed_with_feedback(self):
        client, now = self.run_external()
        identity, result = self.start(client, self.path(now, 0.2, 5.0, path_tolerance=[Tolerance(JOINTS[0], 0.1)]))
        feedback = [client.next_feedback()]
        self.assertEqual(client.status_of(identity), EXECUTING)
        feedback += [client.next_feedback() for _ in range(9)]
        for each in feedback:
            self.assertEqual((bytes(each.goal_id), each.joint_names), (bytes(identity), JOINTS))
            for desired, actual, error in zip(each.desired.positions, each.actual.positions, each.error.positions):
                self.assertAlmostEqual(error, desired - actual)
        reply = client.reply(result)
        self.assertEqual((reply.status, reply.error_code), (SUCCEEDED, SUCCESSFUL), reply.error_string)
        self.assertAlmostEqual(self.positions()[JOINTS[0]], now[JOINTS[0]] + 0.2, delta=0.01)
        self.assertEqual(client.status_of(identity), SUCCEEDED)
        # a second one from there
        _, result = self.start(client, self.path(self.positions(), -0.2, 2.0))
        self.assertEqual(client.reply(result).status, SUCCEEDED)

    def test_a_cancelled_goal_ends_before_its_last_point(self):
        client, now = self.run_external()
        identity, result = self.start(client, self.path(now, 0.5, 20.0))
        client.next_feedback()
        self.assertEqual(client.cancel(list(random.Random(3).randbytes(16))).return_code, 2, "an unknown goal")
        cancelled = client.cancel(identity)
        self.assertEqual((cancelled.return_code, len(cancelled.goals_canceling)), (0, 1))
        self.assertEqual(client.reply(result).status, CANCELED)
        self.assertLess(abs(self.positions()[JOINTS[0]] - now[JOINTS[0]]), 0.4)
        self.assertEqual(client.cancel(identity).return_code, 3, "it has ended")
        _, result = self.start(client, self.path(self.positions(), 0.1, 20.0))
        self.assertEqual(client.cancel(NO_IDENTITY).return_code, 0)
        self.assertEqual(client.reply(result).status, CANCELED)

    def test_the_next_goal_replaces_the_one_before_of_another_client(self):
        client, now = self.run_external()
        other = ActionClient(DOMAIN, ACTION)
        _, first = self.start(client, self.path(now, 0.5, 20.0))
        client.next_feedback()
        identity, second = self.start(other, self.path(now, 0.1, 2.0))
        self.assertEqual(client.reply(first).status, CANCELED)
        self.assertEqual(other.reply(second).status, SUCCEEDED)
        self.assertFalse(client.start(self.path(now, 0.1, 2.0), identity)[0], "the identity is known")

    def test_a_trajectory_that_the_robot_cannot_follow_is_aborted(self):
        client, now = self.run_external()
        _, result = self.start(client, self.path(now, 0.5, 0.01))
        reply = client.reply(result)
        self.assertEqual((reply.status, reply.error_code), (ABORTED, INVALID_GOAL))
        self.assertNotEqual(reply.error_string, "")
        old = self.path(now, 0.1, 1.0)
        old.trajectory.header = Header(Moment(-100, 0))
        _, result = self.start(client, old)
        self.assertEqual(client.reply(result).error_code, OLD_HEADER_TIMESTAMP)
        _, result = self.start(client, self.path(now, 0.3, 1.0, path_tolerance=[Tolerance(JOINTS[0], 1e-7)]))
        reply = client.reply(result)
        self.assertEqual((reply.status, reply.error_code), (ABORTED, PATH_TOLERANCE_VIOLATED), reply.error_string)
        _, result = self.start(client, self.path(self.positions(), 0.1, 1.0, goal_tolerance=[Tolerance(JOINTS[0], 1e-12)]))
        reply = client.reply(result)
        self.assertEqual((reply.status, reply.error_code), (ABORTED, GOAL_TOLERANCE_VIOLATED), reply.error_string)

    def test_open_goals_are_aborted_when_the_run_ends(self):
        client, now = self.run_external()
        _, result = self.start(client, self.path(now, 0.5, 20.0))
        client.next_feedback()
        self.runs[0].operate("stop")
        self.assertEqual(client.reply(result).status, ABORTED)

    def test_a_robot_that_is_not_yielded_takes_no_goal(self):
        run = self.run_task(PRESS, "--clock", "paced", "--hold")
        log = Readers({"/rosout": ("rcl_interfaces/msg/Log", {"reliability": "reliable", "durability": "transient_local"})})
        client = ActionClient(DOMAIN, ACTION)
        accepted, _, result = client.start(goal_of(JOINTS, [(1, [0] * 6)]))
        self.assertFalse(accepted)
        self.assertEqual(client.reply(result).status, UNKNOWN)
        end = time.monotonic() + 60
        while (line := log.read(timeout=0.1).get("/rosout")) is None or "not yielded" not in line.msg:
            self.assertLess(time.monotonic(), end, "no line of the log")
        self.assertEqual(line.level, 30)
        self.assertIsNone(run.process.poll())

    def test_the_topics_are_those_of_the_distribution(self):
        for distro, expected in (("humble", ""), ("jazzy", f"typehash={HASHES['jazzy']};"), ("kilted", f"typehash={HASHES['kilted']};")):
            with self.subTest(distro):
                run = self.run_task(PRESS, "--clock", "paced", "--hold", table=f'commands = true\ndistro = "{distro}"')
                found = endpoints(DOMAIN, {f"rt{ACTION}/_action/{topic}" for topic in ("feedback", "status")})
                self.assertEqual(found[f"rt{ACTION}/_action/feedback"], (FEEDBACK, expected))
                self.assertEqual(found[f"rt{ACTION}/_action/status"][0], "action_msgs::msg::dds_::GoalStatusArray_")
                run.operate("stop")
                run.process.wait()
                shutil.rmtree(self.folder / "press")

    def test_without_commands_there_is_no_action(self):
        self.run_task(PRESS, "--clock", "paced", "--hold", table="")
        self.assertFalse([name for name in endpoints(DOMAIN, {"rt/tf", "rt/joint_states"}) if "_action" in name])

    def test_a_flood_of_requests_changes_nothing(self):
        run = self.run_task(PRESS, "--clock", "paced", "--hold")
        client = ActionClient(DOMAIN, ACTION)
        bridge = run.bridge()
        memory = self.memory(bridge)
        goal = goal_of(JOINTS, [(i + 1, [0] * 6) for i in range(2000)])
        large = goal_of(["x" * (5 << 20)], [])
        for number in range(300):
            client.send("send_goal", list(number.to_bytes(16, "big")), goal)
            client.send("get_result", list(number.to_bytes(16, "big")))
            client.send("cancel_goal", ros2_action.GoalInfo(list(number.to_bytes(16, "big"))))
            if number % 20 == 0:
                client.send("send_goal", list(number.to_bytes(16, "big")), large)
        self.assertFalse(client.start(goal)[0])
        self.assertLess(self.memory(bridge) - memory, 100 << 20)
        self.assertIsNone(run.process.poll())

    @staticmethod
    def memory(pid):
        status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
        return next(int(line.split()[1]) for line in status.splitlines() if line.startswith("VmRSS")) * 1024


if __name__ == "__main__":
    enter_network()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
