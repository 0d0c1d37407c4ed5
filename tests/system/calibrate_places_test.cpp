// `mrroc calibrate base` and `camera` in worlds with errors: the results against the truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "config/deployment.hpp"
#include "geometry/rigid_motion.hpp"
#include "sim/errors/true_errors.hpp"
#include "system/calibration_files.hpp"
#include "system/mrroc_run.hpp"
#include "system/true_arm.hpp"

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

/// Of the pose of a second arm in the frame of the first, where both meet, above the plate.
Distance between_at_meeting(const Pose& found, const Pose& truth) {
  const Pose meeting = pose_from_rpy({0.86, 0.08, -0.3}, {0, 0, 0});
  return between(meeting.inverse() * found * truth.inverse() * meeting, Pose::Identity());
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

/// The base of a robot that was measured before, as it was found with the marker at `marker`, and as this arm, with its
/// own account of its joints and links, is right in this world.
struct MeasuredBase {
  Pose found, truth;
};

MeasuredBase measured_base(const ScratchFolder& folder, const std::string& robot, const std::string& away,
                           const Pose& marker, const std::string& seed) {
  const auto deployment = two_arms(folder, away), file = folder / (robot + "_arm.toml");
  run_mrroc({"calibrate", "kinematics", deployment.string(), "--robot", robot, "--into", file.string(), "--errors",
             "modest", "--seed", seed, "--quiet"},
            0);
  std::string text = text_of(deployment);
  replace(text, "[deployment]\n", "[deployment]\ncalibration = ['" + file.string() + "']\n");
  const auto calibrated = folder.write("measured.toml", text);
  const MeasuredArm measured = config::load_deployment(calibrated).robot(robot).measured_arm;
  TrueArm arm(errors_of(folder, config::errors_set("modest"), seed), deployment, robot);
  return {calibrated_base(folder, calibrated, robot, marker, {"--errors", "modest", "--seed", seed}),
          arm.base(measured)};
}

/// Two measured arms that look at one marker are right to each other, even if it is not where it should be.
TEST(CalibrateBase, TwoMeasuredArmsFindEachOther) {
  const bool thorough = std::getenv("MRROC_TEST_THOROUGH") != nullptr;
  for (const std::string& seed :
       thorough ? std::vector<std::string>{"1", "2", "3", "4", "5"} : std::vector<std::string>{"1"}) {
    const ScratchFolder folder;
    const Pose misplaced = kMarker * pose_from_rpy({0.004, -0.003, 0.005}, {0.01, 0.0, -0.02});
    const MeasuredBase arm = measured_base(folder, "arm", "other", misplaced, seed);
    const MeasuredBase other = measured_base(folder, "other", "arm", misplaced, seed);
    // each arm by itself: the marker in its base frame
    for (const auto& [name, base] : {std::pair("arm", arm), std::pair("other", other)}) {
      const Distance alone = between(base.found.inverse() * misplaced, base.truth.inverse() * kMarker);
      std::printf("seed %s, %s: %.3f mm, %.2f mrad\n", seed.c_str(), name, 1000 * alone.position,
                  1000 * alone.rotation);
      EXPECT_LT(alone.position, 0.0002);
      EXPECT_LT(alone.rotation, 0.1 * std::numbers::pi / 180);
    }
    const Distance both = between_at_meeting(arm.found.inverse() * other.found, arm.truth.inverse() * other.truth);
    std::printf("seed %s, to each other: %.3f mm, %.2f mrad\n", seed.c_str(), 1000 * both.position,
                1000 * both.rotation);
    std::fflush(stdout);
    EXPECT_LT(both.position, std::numbers::sqrt2 * 0.0002);
    EXPECT_LT(both.rotation, std::numbers::sqrt2 * 0.1 * std::numbers::pi / 180);
  }
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
