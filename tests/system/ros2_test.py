"""The bridge to ROS 2, seen by two other implementations of DDS: rosless (Rust) and Cyclone DDS 11.

ros2_test.py BUILD_FOLDER SOURCE_FOLDER [NAME...]
"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy
from ros2_peers import DOMAIN, PRESS, SOURCE, Flood, Run, enter_network, hash_of, udp_ports
from ros2_readers import Readers
from ros2_trigger import TriggerClient, endpoints

TOPICS = {  # of press: type, whether a late subscriber receives the last message
    "/joint_states": ("sensor_msgs/msg/JointState", False),
    "/tf": ("tf2_msgs/msg/TFMessage", False),
    "/tf_static": ("tf2_msgs/msg/TFMessage", True),
    "/robot_description": ("std_msgs/msg/String", True),
    "/clock": ("rosgraph_msgs/msg/Clock", False),
    "/wrist/wrench": ("geometry_msgs/msg/WrenchStamped", False),
    "/wrench": ("geometry_msgs/msg/WrenchStamped", False),
    "/diagnostics": ("diagnostic_msgs/msg/DiagnosticArray", False),
    "/rosout": ("rcl_interfaces/msg/Log", True),
}
INSPECT = SOURCE / "tasks/inspect/inspect.toml"
CAMERA_TOPICS = {  # of inspect
    "/eye/image_raw": ("sensor_msgs/msg/Image", False),
    "/eye/camera_info": ("sensor_msgs/msg/CameraInfo", False),
}
BENCH_TOPICS = {"/lab/bench/" + name.split("/")[-1]: kind for name, kind in CAMERA_TOPICS.items()}
KINDS = TOPICS | CAMERA_TOPICS | BENCH_TOPICS
PUBLISHED_HASHES = {
    "std_msgs::msg::dds_::String_": "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18",
    "sensor_msgs::msg::dds_::JointState_": "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e",
    "sensor_msgs::msg::dds_::Image_": "RIHS01_d31d41a9a4c4bc8eae9be757b0beed306564f7526c88ea6a4588fb9582527d47",
    "sensor_msgs::msg::dds_::CameraInfo_": "RIHS01_b3dfd68ff46c9d56c80fd3bd4ed22c7a4ddce8c8348f2f59c299e73118e7e275",
}
JOINTS = ["column", "lower_arm", "upper_arm", "wrist_pitch", "wrist_roll", "tool_roll"]


def seconds(stamp):
    return stamp.sec + stamp.nanosec * 1e-9


def matrix(transform):
    x, y, z, w = (getattr(transform.rotation, name) for name in "xyzw")
    own = numpy.eye(4)
    own[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                   [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                   [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    own[:3, 3] = [getattr(transform.translation, name) for name in "xyz"]
    return own


class Ros2(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.runs = []

    def tearDown(self):
        for run in self.runs:
            run.close()
        shutil.rmtree(self.folder)

    def run_press(self, *words, deployment=PRESS):
        run = Run(self.folder, deployment, *words)
        self.runs.append(run)
        return run

    def deployment(self, table):
        """press with this text as its table [ros2]."""
        shutil.copytree(SOURCE / "tasks/press", self.folder / "press")
        file = self.folder / "press/press.toml"
        file.write_text(file.read_text(encoding="utf-8") + f"\n[ros2]\n{table}\n", encoding="utf-8")
        return file

    def receive(self, names, enough, ready=lambda: None):
        """Messages of these topics until each has `enough`, or one; `ready` is called when all are subscribed."""
        durability = {True: "transient_local", False: "volatile"}
        readers = Readers({name: (KINDS[name][0], {"reliability": "reliable", "durability": durability[KINDS[name][1]]}) for name in names})
        ready()
        found = {name: [] for name in names}
        end = time.monotonic() + 60
        while any(len(found[name]) < (1 if KINDS[name][1] else enough) for name in names):
            self.assertLess(time.monotonic(), end, {name: len(each) for name, each in found.items()})
            for name, message in readers.read(timeout=0.002).items():
                found[name].append(message)
        return found

    def test_rosless_sees_every_message_of_a_run(self):
        run = self.run_press("--clock", "paced", "--ros2", "--hold")
        run.wait_for("ros2: node /mrroc_press in domain 7")
        found = self.receive([name for name in TOPICS if name not in ("/wrist/wrench", "/wrench", "/rosout")], 3)
        found |= self.receive(["/wrist/wrench", "/rosout"], 1, ready=lambda: run.operate("start"))
        for state in found["/joint_states"]:
            self.assertEqual(state.name, JOINTS)
            self.assertEqual((len(state.position), len(state.velocity)), (6, 6))
        stamps = [seconds(state.header.stamp) for state in found["/joint_states"]]
        self.assertEqual(stamps, sorted(stamps))
        self.assertEqual([seconds(each.clock) for each in found["/clock"]], sorted(seconds(each.clock) for each in found["/clock"]))
        self.assertTrue(all(abs(stamp / 0.002 - round(stamp / 0.002)) < 1e-6 for stamp in stamps), "not the times of ticks")
        self.assertEqual(found["/wrist/wrench"][0].header.frame_id, "wrist")
        self.assertIn('<robot name="irb6">', found["/robot_description"][0].data)
        names = {status.name for status in found["/diagnostics"][-1].status}
        self.assertLessEqual({"press: process arm_edp", "press: robot arm"}, names)
        # the chain of the URDF's links ends where the robot's own kinematics has its tool
        fixed = {each.child_frame_id: each for each in found["/tf_static"][0].transforms}
        moving = {each.child_frame_id: each for each in found["/tf"][-1].transforms}
        self.assertEqual(fixed["base"].header.frame_id, "world")
        self.assertAlmostEqual(fixed["base"].transform.translation.z, 0.7)
        frames = fixed | moving
        chain, name = numpy.eye(4), "tool_frame"
        while name != "base":
            chain = matrix(frames[name].transform) @ chain
            name = frames[name].header.frame_id
        self.assertEqual(moving["arm_tool"].header.frame_id, "base")
        self.assertEqual(moving["arm_flange"].header.frame_id, "base")
        self.assertEqual(fixed["wrist"].header.frame_id, "arm_flange")
        numpy.testing.assert_allclose(chain, matrix(moving["arm_tool"].transform), atol=1e-6)

    def test_topics_have_the_types_and_hashes_of_ros2(self):
        run = self.run_press("--clock", "paced", "--ros2", "--hold")
        run.wait_for("ros2: node")
        found = endpoints(DOMAIN, {f"rt{name}" for name in TOPICS if name != "/wrench"})
        for name, (kind, _) in TOPICS.items():
            if name == "/wrench":
                continue
            package, _, message = kind.split("/")
            type_name, data = found[f"rt{name}"]
            self.assertEqual(type_name, f"{package}::msg::dds_::{message}_")
            self.assertRegex(data, "^typehash=RIHS01_[0-9a-f]{64};$")
            if type_name in PUBLISHED_HASHES:
                self.assertEqual(data, f"typehash={PUBLISHED_HASHES[type_name]};")

    def test_each_of_several_robots_has_its_own_topics_and_frames(self):
        run = self.run_press("--clock", "paced", "--ros2", "--hold", deployment=SOURCE / "tasks/cooperative_transfer/cooperative_transfer.toml")
        run.wait_for("ros2: node /mrroc_cooperative_transfer")
        robots = ("left", "right", "left_gripper", "right_gripper")
        found = endpoints(DOMAIN, {f"rt/{robot}/joint_states" for robot in robots} | {"rt/tf_static"})
        self.assertNotIn("rt/joint_states", found)
        messages = self.receive(["/tf", "/tf_static"], 20)
        parents = {}
        for message in (*messages["/tf"], *messages["/tf_static"]):
            for each in message.transforms:
                parent = parents.setdefault(each.child_frame_id, each.header.frame_id)
                self.assertEqual(parent, each.header.frame_id, f"two parents of {each.child_frame_id}")
        for arm in ("left", "right"):
            self.assertEqual(parents[f"{arm}_wrist"], f"{arm}/{arm}_flange")
        for frame in parents:
            self.assertTrue(frame.startswith(tuple(f"{robot}/" for robot in robots)) or frame.endswith("_wrist"), frame)
            seen = []
            while frame != "world":
                self.assertNotIn(frame, seen)
                seen.append(frame)
                self.assertIn(frame, parents, f"{seen[0]} is not below the world")
                frame = parents[frame]

    def test_a_simulated_camera_is_pictures_with_their_intrinsics(self):
        run = self.run_press("--clock", "paced", "--ros2", "--hold", deployment=INSPECT)
        run.wait_for("ros2: node /mrroc_inspect")
        found = self.receive(list(CAMERA_TOPICS), 3)
        writers = endpoints(DOMAIN, {f"rt{name}" for name in CAMERA_TOPICS})
        for type_name, data in (writers[f"rt{name}"] for name in CAMERA_TOPICS):
            self.assertEqual(data, f"typehash={PUBLISHED_HASHES[type_name]};")
        focal = 240 / 2 / numpy.tan(0.8 / 2)
        for image in found["/eye/image_raw"]:
            self.assertEqual((image.width, image.height, image.step, image.encoding), (320, 240, 960, "rgb8"))
            pixels = numpy.frombuffer(bytes(image.data), numpy.uint8).reshape(240, 320, 3)
            self.assertLess(pixels.min(), 60)
            self.assertGreater(pixels.max(), 150)
            self.assertGreater(len(numpy.unique(pixels)), 20)
        for info in found["/eye/camera_info"]:
            self.assertEqual((info.width, info.height, info.header.frame_id), (320, 240, "eye"))
            numpy.testing.assert_allclose(info.k, [focal, 0, 159.5, 0, focal, 119.5, 0, 0, 1])
        images, infos = ([seconds(each.header.stamp) for each in found[name]] for name in CAMERA_TOPICS)
        self.assertTrue(set(images) & set(infos), "a picture and its intrinsics have one time")
        pictures = self.receive(["/eye/image_raw", "/tf"], 60)["/tf"]
        frames = [each for message in pictures for each in message.transforms if each.child_frame_id == "eye"]
        self.assertTrue(frames, "no frame of the camera")
        self.assertEqual({each.header.frame_id for each in frames}, {"world"})

    def test_a_camera_of_hardware_is_the_pictures_of_its_readings(self):
        file = self.deployment("namespace = \"/lab\"")
        with open(file.parent / "bench.y4m", "wb") as video:  # picture k has the brightness 40 + 10 (k mod 15)
            video.write(b"YUV4MPEG2 W64 H48 F25:1 Ip A1:1 C444\n")
            for number in range(3000):
                video.write(b"FRAME\n" + bytes([40 + 10 * (number % 15)]) * (64 * 48) + bytes([128]) * (2 * 64 * 48))
        with open(file, "a", encoding="utf-8") as text:
            text.write("""
[sensors.bench]
type = "camera"
source = "hardware"
device = "bench.y4m"
width = 64
height = 48
intrinsics = [80.0, 81.0, 31.0, 23.0]
distortion = [0.1, -0.2, 0.001, 0.002, 0.05]
focal_scale = 1.01
position = [1.3, 0.0, 1.3]
rotation = [2.4434609527920612, 0.0, -1.5707963267948966]
plane = [1.3, 1.0, 0.0]
mode = "non-interactive"
rate = 25
""")
        run = self.run_press("--clock", "paced", "--hold", deployment=file)
        run.wait_for("ros2: node /lab/mrroc_press")
        found = self.receive(["/lab/bench/image_raw", "/lab/bench/camera_info", "/tf_static"], 12)
        stamps = [seconds(each.header.stamp) for each in found["/lab/bench/image_raw"]]
        self.assertEqual(stamps, sorted(set(stamps)))
        for image, stamp in zip(found["/lab/bench/image_raw"], stamps):
            self.assertEqual((image.width, image.height, image.step, image.encoding), (64, 48, 192, "rgb8"))
            number = int(stamp * 25 + 1e-6)
            self.assertAlmostEqual(stamp, number / 25, places=6, msg="the picture's own tick")
            shown = numpy.frombuffer(bytes(image.data), numpy.uint8).astype(float)
            numpy.testing.assert_allclose(shown, (24 + 10 * (number % 15)) * 255 / 219, atol=4)
        info = found["/lab/bench/camera_info"][0]
        numpy.testing.assert_allclose(info.k, [80.8, 0, 31, 0, 81.81, 23, 0, 0, 1])
        numpy.testing.assert_allclose(info.d, [0.1, -0.2, 0.001, 0.002, 0.05])
        frame, = (each for each in found["/tf_static"][0].transforms if each.child_frame_id == "bench")
        self.assertEqual((frame.header.frame_id, frame.transform.translation.x), ("world", 1.3))

    def test_who_receives_pictures_changes_nothing(self):
        recording = self.folder / "quiet.mcap"
        self.run_press("--clock", "lockstep", "--record", recording, deployment=INSPECT).end()
        readers = Readers({"/eye/image_raw": (CAMERA_TOPICS["/eye/image_raw"][0], {})})
        pictures, hashes = 0, set()
        for number in range(20):  # on a busy machine a run may be over before its first picture is drawn
            watched = self.folder / f"{number}.mcap"
            run = self.run_press("--clock", "lockstep", "--ros2", "--record", watched, deployment=INSPECT)
            while run.process.poll() is None:
                pictures += len(readers.read(timeout=0.05))
            run.end()
            hashes.add(hash_of(watched))
            if pictures:
                break
        self.assertGreater(pictures, 0)
        self.assertEqual(hashes, {hash_of(recording)})

    def test_real_robots_have_the_systems_time(self):
        before = time.time()
        run = self.run_press("--clock", "real", "--ros2", "--hold")
        run.wait_for("ros2: node")
        states = self.receive(["/joint_states"], 5)["/joint_states"]
        stamps = [seconds(state.header.stamp) for state in states]
        self.assertTrue(all(before < stamp < time.time() for stamp in stamps), (before, stamps))
        self.assertNotIn("rt/clock", endpoints(DOMAIN, {"rt/tf", "rt/joint_states"}))

    def test_nodes_of_this_machine_find_one_that_only_this_machine_sees(self):
        run = self.run_press("--clock", "paced", "--hold", deployment=self.deployment('interface = "lo"'))
        run.wait_for("ros2: node")
        local = ("<General><Interfaces><NetworkInterface address='127.0.0.1' multicast='false'/></Interfaces></General>"
                 "<Discovery><ParticipantIndex>auto</ParticipantIndex><Peers><Peer Address='127.0.0.1'/></Peers></Discovery>")
        code = f"import ros2_trigger; print(ros2_trigger.endpoints({DOMAIN}, {{'rt/joint_states'}})['rt/joint_states'][0])"
        done = subprocess.run([sys.executable, "-c", code], env=dict(os.environ, CYCLONEDDS_URI=local), cwd=SOURCE / "tests/system",
                              capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), "sensor_msgs::msg::dds_::JointState_")

    def test_humble_has_no_hashes(self):
        run = self.run_press("--clock", "paced", "--hold", deployment=self.deployment('distro = "humble"\nnamespace = "/lab"'))
        run.wait_for("ros2: node /lab/mrroc_press in domain 7")
        found = endpoints(DOMAIN, {"rt/lab/joint_states", "rt/tf"})
        self.assertEqual(found["rt/lab/joint_states"], ("sensor_msgs::msg::dds_::JointState_", ""))

    def test_services_operate_the_run(self):
        run = self.run_press("--clock", "paced", "--hold", deployment=self.deployment("commands = true"))
        run.wait_for("ros2: node")
        client = TriggerClient(DOMAIN)
        other = TriggerClient(DOMAIN)
        end = time.monotonic() + 60
        while "being started" in client.call("/mrroc_press/resume")[1]:  # the bridge may be there before the task is held
            self.assertLess(time.monotonic(), end)
        self.assertEqual(client.call("/mrroc_press/resume")[0], False)
        self.assertEqual(client.call("/mrroc_press/start")[0], True)
        self.assertEqual(client.call("/mrroc_press/pause")[0], True)
        # each client gets the replies to its own requests
        first, second = client.send("/mrroc_press/pause"), other.send("/mrroc_press/resume")
        self.assertEqual((client.reply("/mrroc_press/pause", first)[0], other.reply("/mrroc_press/resume", second)[0]), (False, True))
        self.assertEqual(client.call("/mrroc_press/stop")[0], True)
        run.end(expected=5)

    def test_without_commands_there_is_no_service(self):
        run = self.run_press("--clock", "paced", "--ros2", "--hold")
        run.wait_for("ros2: node")
        found = endpoints(DOMAIN, {"rt/tf"})
        self.assertFalse([name for name in found if name.startswith(("rq/", "rr/"))])

    def test_the_trace_is_the_same_whatever_happens_to_the_bridge(self):
        hashes = set()
        for number, signals in enumerate(([], [signal.SIGKILL], [signal.SIGSTOP])):
            recording = self.folder / f"{number}.mcap"
            run = self.run_press("--clock", "lockstep", "--ros2", "--record", recording)
            run.wait_for("ros2: node")
            bridge = run.bridge()
            for each in signals:
                os.kill(bridge, each)
            text = run.end()
            if signals == [signal.SIGKILL]:
                self.assertIn("the process 'ros2' has ended", text)
            hashes.add(hash_of(recording))
        recording = self.folder / "without.mcap"
        self.run_press("--clock", "lockstep", "--record", recording).end()
        self.assertEqual(hashes, {hash_of(recording)})

    def test_a_flood_of_the_bridge_changes_nothing(self):
        quiet, deployment = self.folder / "quiet.mcap", self.deployment("commands = true")
        self.run_press("--clock", "lockstep", "--record", quiet).end()
        datagrams = requests = number = 0
        while min(datagrams, requests) <= 1000:  # on a busy machine a run ends before it has met so many
            number += 1
            self.assertLess(number, 10)
            flooded = self.folder / f"{number}.mcap"
            run = self.run_press("--clock", "lockstep", "--record", flooded, deployment=deployment)
            run.wait_for("ros2: node")
            flood = Flood(udp_ports(run.bridge()))
            client = TriggerClient(DOMAIN)
            while run.process.poll() is None:
                client.send("/mrroc_press/resume")  # refused: nothing is paused
            run.end()
            arrived, rate = flood.end()
            print(f"{arrived} datagrams, {rate:.0f} a second, {client.last} requests")
            datagrams, requests = datagrams + arrived, requests + client.last
            self.assertEqual(hash_of(quiet), hash_of(flooded))

    def test_a_bridge_that_cannot_start_ends_the_run_before_anything_moves(self):
        run = self.run_press("--clock", "lockstep", deployment=self.deployment('interface = "nowhere0"'))
        text = run.end(expected=2)
        self.assertEqual(text.count("nowhere0"), 1, text)
        self.assertNotIn("running", text)


if __name__ == "__main__":
    enter_network()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
