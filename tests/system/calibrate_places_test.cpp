// `mrroc calibrate base` and `camera` in worlds with errors: the results against the truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "config/deployment.hpp"
#include "geometry/rigid_motion.hpp"
#include "sim/errors/true_errors.hpp"
#include "system/calibration_files.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::calibrate_places_test {
namespace {

/// The marker of tasks/inspect in the world, from its scene.
const Pose kMarker =
    pose_from_rpy({0.82, 0.06, 0.36}, {0, 0, 0}) *
    Pose(Eigen::AngleAxisd(0.16, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.12, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ())) *
    Eigen::Translation3d(0.06, 0, 0.01);

/// tasks/inspect with another arm at the other side of the plate; the one named `away` has turned from it.
std::filesystem::path two_arms(const ScratchFolder& folder, const std::string& away) {
  std::string parameters = text_of(MRROC_SOURCE_DIR "/robots/irb6/irb6.toml");
  replace(parameters, "home = [0.0,", "home = [1.4,");
  folder.write("away.toml", parameters);
  std::string text = text_of(MRROC_SOURCE_DIR "/tasks/inspect/inspect.toml");
  replace(text, "\"inspect.xml\"", "'" MRROC_SOURCE_DIR "/tasks/inspect/inspect.xml'");
  text += R"(
[robots.other]
type = "irb6"
hardware = "mujoco"
position = [1.72, 0.14, 0.7]
rotation = [0.0, 0.0, 3.141592653589793]

[sensors.other_eye]
type = "camera"
robot = "other"
frame = "camera"
position = [0.08, 0.0, 0.06]
rotation = [0.0, 0.0, 1.5707963267948966]
width = 320
height = 240
field_of_view = 0.8
detect = "marker"
dictionary = "4X4_50"
marker = 11
marker_size = 0.09
)";
  replace(text, "[robots." + away + "]\n", "[robots." + away + "]\nparameters = 'away.toml'\n");
  return folder.write("two_arms.toml", text);
}

/// The base of a robot as found with the marker at `marker` in the world.
Pose calibrated_base(const ScratchFolder& folder, const std::filesystem::path& deployment, const std::string& robot,
                     const Pose& marker, const std::vector<std::string>& errors) {
  const auto file = folder / (robot + ".toml");
  std::vector<std::string> arguments{"calibrate", "base",   deployment.string(), "--robot",
                                     robot,       "--into", file.string(),       "--quiet"};
  arguments.insert(arguments.end(), errors.begin(), errors.end());
  const Eigen::Vector3d turns = rpy_of(marker.linear());
  for (int i = 0; i < 3; ++i) {
    arguments.insert(arguments.end(), {std::string{"--"} + "xyz"[i], std::to_string(marker.translation()[i])});
    arguments.insert(arguments.end(),
                     {std::array{"--roll", "--pitch", "--yaw"}[static_cast<std::size_t>(i)], std::to_string(turns[i])});
  }
  run_mrroc(arguments, 0);
  const config::Table found = config::Table::load(file).table("robots").table(robot);
  return pose_from_rpy(vector(found, "base_position"), vector(found, "base_rotation"));
}

struct Distance {
  double position = 0, rotation = 0;  // m, rad
};

Distance between(const Pose& a, const Pose& b) {
  return {(a.translation() - b.translation()).norm(), rotation_vector(a.linear().transpose() * b.linear()).norm()};
}

TEST(CalibrateBase, FindsWhereAnExactArmStands) {
  const ScratchFolder folder;
  const auto set = folder.write("base.toml", "base_position = 0.003\nbase_rotation = 0.003\ncamera_position = 0.002\n");
  const config::Deployment inspect = config::load_deployment(MRROC_SOURCE_DIR "/tasks/inspect/inspect.toml");
  const config::ErrorsEntry errors = errors_of(folder, set, "1");
  const Pose nominal = inspect.robot("arm").base, truth = nominal * sim::error_of_base(errors, "arm");
  const Pose found = calibrated_base(
      folder, inspect.file, "arm", kMarker,
      {"--errors", set.string(), "--seed", "1", "--joint-deviation", "1e-6", "--arm-deviation", "1e-5"});
  const Distance before = between(nominal, truth), after = between(found, truth);
  std::printf("%.3f mm, %.2f mrad before, %.3f mm, %.2f mrad after\n", 1000 * before.position, 1000 * before.rotation,
              1000 * after.position, 1000 * after.rotation);
  EXPECT_LT(after.position, std::max(0.0002, 0.1 * before.position));
  EXPECT_LT(after.rotation, 0.1 * std::numbers::pi / 180);
}

/// Two arms that look at one marker are right to each other, even if it is not where it should be.
TEST(CalibrateBase, TwoArmsFindEachOther) {
  const ScratchFolder folder;
  const config::Deployment deployment = config::load_deployment(two_arms(folder, "other"));
  const Pose misplaced = kMarker * pose_from_rpy({0.004, -0.003, 0.005}, {0.01, 0.0, -0.02});
  const std::vector<std::string> modest{"--errors", "modest", "--seed", "1"};
  const config::ErrorsEntry errors = errors_of(folder, config::errors_set("modest"), "1");
  const Pose arm = deployment.robot("arm").base, other = deployment.robot("other").base;
  const Pose truth = (arm * sim::error_of_base(errors, "arm")).inverse() * other * sim::error_of_base(errors, "other");
  const Pose found = calibrated_base(folder, two_arms(folder, "other"), "arm", misplaced, modest).inverse() *
                     calibrated_base(folder, two_arms(folder, "arm"), "other", misplaced, modest);
  // where both meet, above the plate
  const Pose meeting = pose_from_rpy({0.86, 0.08, -0.3}, {0, 0, 0});
  const auto at_meeting = [&](const Pose& pose) { return Pose(meeting.inverse() * pose * truth.inverse() * meeting); };
  const Distance before = between(at_meeting(arm.inverse() * other), Pose::Identity());
  const Distance after = between(at_meeting(found), Pose::Identity());
  std::printf("%.3f mm, %.2f mrad before, %.3f mm, %.2f mrad after\n", 1000 * before.position, 1000 * before.rotation,
              1000 * after.position, 1000 * after.rotation);
  EXPECT_LT(after.position, 0.7 * before.position);
  EXPECT_LT(after.rotation, 0.5 * before.rotation);
}

/// A camera on the floor and an arm that carries a marker above it.
constexpr const char* kLookoutScene = R"(<mujoco model="lookout">
  <compiler angle="radian"/>
  <option timestep="0.001"/>
  <visual>
    <headlight ambient="0.4 0.4 0.4" diffuse="0.35 0.35 0.35" specular="0 0 0"/>
    <quality offsamples="4"/>
  </visual>
  <asset>
    <texture name="marker" type="2d" file="MARKER"/>
    <material name="marker" texture="marker" texuniform="false" specular="0" shininess="0"/>
  </asset>
  <worldbody>
    <body name="plate" pos="0.75 0 0.6" quat="0 1 0 0">
      <freejoint/>
      <geom name="plate" type="box" size="0.06 0.06 0.002" mass="0.1" material="marker" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
  <equality>
    <weld body1="arm/tool" body2="plate" relpose="0.02 0 0.21 1 0 0 0" solref="0.002 1" solimp="0.99 0.999 0.0001"/>
  </equality>
</mujoco>
)";
constexpr const char* kLookoutCell = R"([deployment]
name = "lookout"
clock = "lockstep"

[robots.arm]
type = "irb6"
hardware = "mujoco"
position = [0.0, 0.0, 0.7]

[sensors.lookout]
type = "camera"
frame = "world"
position = [0.85, 0.02, 0.2]
width = 320
height = 240
field_of_view = 0.8
detect = "marker"
dictionary = "4X4_50"
marker = 11
marker_size = 0.09

[sim]
scene = "scene.xml"
)";

TEST(CalibrateCamera, FindsACameraThatDoesNotMove) {
  const ScratchFolder folder;
  std::string scene = kLookoutScene;
  replace(scene, "MARKER", MRROC_SOURCE_DIR "/tasks/inspect/marker_4x4_50_11.png");
  folder.write("scene.xml", scene);
  const auto cell = folder.write("cell.toml", kLookoutCell);
  const auto set = folder.write("camera.toml",
                                "camera_position = 0.003\ncamera_rotation = 0.003\nfocal_length = 0.003\n"
                                "distortion = 0.01\npixel_noise = 2\nblur = 0.5\n");
  for (const std::string seed : {"1", "2", "3"}) {
    const auto file = folder / ("eye_" + seed + ".toml");
    run_mrroc({"calibrate", "camera", cell.string(), "--into", file.string(), "--errors", set.string(), "--seed", seed,
               "--joint-deviation", "1e-6", "--arm-deviation", "1e-5", "--quiet"},
              0);
    const config::ErrorsEntry errors = errors_of(folder, set, seed);
    const config::Table eye = config::Table::load(file).table("sensors").table("lookout");
    const Pose nominal = pose_from_rpy({0.85, 0.02, 0.2}, {0, 0, 0});
    const Pose truth = nominal * sim::error_of_camera(errors, "lookout");
    const Pose found = pose_from_rpy(vector(eye, "mount_position"), vector(eye, "mount_rotation"));
    const Distance before = between(nominal, truth), after = between(found, truth);
    const double focal = eye.number("focal_scale") - 1 - sim::error_of_lens(errors, "lookout").focal;
    std::printf("%.3f mm, %.2f mrad before, %.3f mm, %.2f mrad, focal length %.5f after\n", 1000 * before.position,
                1000 * before.rotation, 1000 * after.position, 1000 * after.rotation, focal);
    EXPECT_LT(after.position, std::max(0.0002, 0.1 * before.position));
    EXPECT_LT(after.rotation, 0.1 * std::numbers::pi / 180);
    EXPECT_LT(std::abs(focal), 0.001);
    EXPECT_EQ(config::load_deployment(with_calibration(folder, cell.string(), "scene.xml", file)).sensors.size(), 1U);
  }
}

}  // namespace
}  // namespace mrroc::test::calibrate_places_test
