#include "sensors/camera/seen_world.hpp"

namespace mrroc::vsp::wrong_input_test {
namespace {

struct Mistake {
  const char* name;
  std::string world;  ///< of the scene
  std::string keys;
  std::string refusal;
  std::string robot = "";
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.name; }

class WrongCamera : public testing::TestWithParam<Mistake> {};

TEST_P(WrongCamera, IsRefusedWithKeyValueAndExpectation) {
  const Mistake& mistake = GetParam();
  config::RobotEntry arm;
  arm.name = "arm";
  arm.type = "irb6";
  arm.driver.world = true;
  config::RobotEntry gripper;
  gripper.name = "gripper";
  gripper.type = "two_finger_gripper";
  gripper.driver.world = false;
  gripper.mount = "arm";
  SeenWorld world(mistake.world.empty() ? "" : scene_of(mistake.world), mistake.keys, mistake.robot, {arm, gripper});
  EXPECT_EQ(refusal([&] { world.open(); }), mistake.refusal);
}

const std::string kEye = kOverhead;
const std::string kHardware = "source = 'hardware'\ndevice = '/dev/video77'\nframe = 'camera'\n";
const std::string kIntrinsics = "intrinsics = [600.0, 600.0, 320.0, 240.0]\n";

INSTANTIATE_TEST_SUITE_P(
    All, WrongCamera,
    testing::Values(
        Mistake{"no_such_camera", "<camera name='front'/><camera name='top'/>", "camera = 'back'",
                "sensors.eye.camera: no camera \"back\", expected one of front, top"},
        Mistake{"no_camera_of_its_name", "<camera name='front'/>", "",
                "sensors.eye.camera: no camera \"eye\", expected one of front, or the keys 'position' and 'rotation'"},
        Mistake{"no_camera_of_its_robot", kEye.substr(0, 0) + "<camera name='front'/>", "",
                "sensors.eye.camera: no camera \"arm/eye, eye\", expected one of front, or the keys 'position' and "
                "'rotation'",
                "arm"},
        Mistake{"camera_in_the_world_with_a_robot", kEye, "",
                "sensors.eye.camera: \"eye\" is fixed to body \"world\", expected one fixed to the flange of robot arm",
                "arm"},
        Mistake{
            "camera_on_something_that_moves",
            "<body name='cart'><freejoint/><geom size='0.1' mass='1'/><camera name='eye'/></body>", "",
            "sensors.eye.camera: \"eye\" is fixed to body \"cart\", expected one that is fixed in the world, or the "
            "key 'robot' beside it"},
        Mistake{"camera_that_tracks", "<camera name='eye' mode='targetbody' target='arm/base'/>", "",
                "sensors.eye.camera: \"eye\" tracks a body, expected mode 'fixed'"},
        Mistake{"two_poses", kEye, "position = [0.0, 0.0, 1.0]",
                "sensors.eye.position: the MJCF's camera \"eye\" has its own pose, expected none"},
        Mistake{"rotation_alone", "<camera name='top'/>", "rotation = [0.0, 0.0, 0.0]",
                "sensors.eye.rotation: a rotation alone, expected the key 'position' beside it"},
        Mistake{"position_of_two", "<camera name='top'/>", "position = [0.0, 1.0]",
                "sensors.eye.position: 2 numbers, expected 3"},
        Mistake{"pose_without_field_of_view", "<camera name='top'/>", "position = [0.0, 0.0, 1.0]",
                "sensors.eye.field_of_view: 0, expected that of the picture's height, rad: the MJCF has no camera that "
                "gives it"},
        Mistake{"robot_without_flange", "<camera name='top'/>", "position = [0.0, 0.0, 1.0]",
                "sensors.eye.position: robot gripper has no body or site \"flange\" in its MJCF, expected a camera in "
                "its MJCF and frame = 'camera'",
                "gripper"},
        Mistake{"no_such_frame", kEye, "frame = 'table'",
                "sensors.eye.frame: \"table\", expected one of world, camera, arm, gripper"},
        Mistake{"frame_of_a_carried_robot", kEye, "frame = 'gripper'",
                "sensors.eye.frame: robot gripper is carried by arm: its base moves, expected a robot that is fixed in "
                "the world, or the camera's own"},
        Mistake{"plane_through_the_camera", kEye, "plane = [0.0, 0.0, 0.9]",
                "sensors.eye.plane: the camera lies in the plane and sees it edge on, expected a plane that the camera "
                "sees"},
        Mistake{"plane_parallel_to_the_view", kEye, "plane = [5.0, 0.0, 0.0]\nplane_normal = [1.0, 0.0, 0.0]",
                ""},  // seen at the horizon: the right half of the picture, far below
        Mistake{"plane_behind", kEye, "plane = [0.0, 0.0, 1.5]",
                "sensors.eye.plane: the plane is parallel to the view or behind the camera: no pixel sees it, expected "
                "a plane that the camera sees"},
        Mistake{"no_normal", kEye, "plane_normal = [0.0, 0.0, 0.0]",
                "sensors.eye.plane_normal: 0, expected a direction"},
        Mistake{"saturation_reversed", kEye, "saturation = [0.9, 0.1]",
                "sensors.eye.saturation: 0.900000 to 0.100000, expected from at most to"},
        Mistake{"nothing_to_detect", kEye, "detect = 'face'", "sensors.eye.detect: \"face\", expected blob or marker"},
        Mistake{"no_such_dictionary", kEye, "detect = 'marker'\ndictionary = '3X3'",
                "sensors.eye.dictionary: \"3X3\", expected one of 4X4_50, 4X4_100, 4X4_250, 4X4_1000, 5X5_50, 5X5_100, "
                "5X5_250, 5X5_1000, 6X6_50, 6X6_100, 6X6_250, 6X6_1000, 7X7_50, 7X7_100, 7X7_250, 7X7_1000, "
                "ARUCO_ORIGINAL, APRILTAG_16h5, APRILTAG_25h9, APRILTAG_36h10, APRILTAG_36h11"},
        Mistake{"marker_beyond_its_dictionary", kEye, "detect = 'marker'\nmarker = 50",
                "sensors.eye.marker: 50, expected 0 to 49, as dictionary 4X4_50"},
        Mistake{"half_a_marker", kEye, "detect = 'marker'\nmarker = 1.5",
                "sensors.eye.marker: 1.500000, expected a whole number"},
        Mistake{"device_of_a_simulated_camera", kEye, "device = '0'",
                "sensors.eye.device: \"0\", expected source = 'hardware' beside it"},
        Mistake{"intrinsics_of_a_simulated_camera", kEye, kIntrinsics,
                "sensors.eye.intrinsics: of a simulated camera, expected source = 'hardware' beside it"},
        Mistake{"no_world", "", "",
                "sensors.eye.source: 'simulated' without a simulated world, expected a table [sim]"},
        Mistake{"no_device", "", "source = 'hardware'\nframe = 'camera'\n" + kIntrinsics,
                "sensors.eye.device: missing, expected a camera's number or address, or a video file"},
        Mistake{"device_that_cannot_be_opened", "", kHardware + kIntrinsics,
                "sensors.eye.device: \"/dev/video77\" cannot be opened, expected a camera's number or address, or a "
                "video file"},
        Mistake{"hardware_without_intrinsics", "", kHardware,
                "sensors.eye.intrinsics: missing, expected fx, fy, cx, cy of this camera, px"},
        Mistake{"hardware_without_a_pose", "", "source = 'hardware'\ndevice = '77'\n" + kIntrinsics,
                "sensors.eye.position: missing, expected the camera's pose ('position', 'rotation'), or frame = "
                "'camera'"},
        Mistake{"hardware_with_noise", "", kHardware + kIntrinsics + "noise = 2.0",
                "sensors.eye.noise: added to a camera of hardware, expected 0"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(WrongCameraKeys, AreRefusedByTheTypesDeclarations) {
  for (const char* keys : {"width = 8", "min_area = 0", "hue = [0.0, 400.0]", "noise = -1.0", "marker_size = 0.0",
                           "colour = 'red'", "debug_every = 0"}) {
    EXPECT_THROW(SeenWorld(scene_of(kOverhead), keys), config::ConfigurationError) << keys;
  }
}

}  // namespace
}  // namespace mrroc::vsp::wrong_input_test
