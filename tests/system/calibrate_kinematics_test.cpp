// `mrroc calibrate kinematics` in a world with errors: the arm as measured against the true one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numbers>

#include "calibration/hand_eye.hpp"
#include "config/deployment.hpp"
#include "kinematics/measured_model.hpp"
#include "system/calibration_files.hpp"
#include "system/mrroc_run.hpp"
#include "system/true_arm.hpp"

namespace mrroc::test::calibrate_kinematics_test {
namespace {

/// How far from where it is the arm expects a marker before its camera, m, after a hand-eye calibration with exact
/// pictures: what is left of the arm's own errors.
struct PlaceError {
  double largest = 0, mean = 0;
};

PlaceError error_of_places(TrueArm& arm, const MeasuredArm& measured) {
  const RobotModels models = kinematics::with_measured(load_irb6(), measured);
  const RobotModel& model = *models.front();
  const std::vector<calibration::MarkerView> views = arm.exact_views(kNominalEye, measured);
  const calibration::HandEyeFit fit =
      calibration::fit_hand_eye(model, views, {.joint = 1e-9, .focal = 1e-9, .k1 = 1e-9});
  PlaceError error;
  for (const calibration::MarkerView& view : views) {
    const Pose expected = (model.flange(view.joints) * fit.camera).inverse() * fit.marker;
    const double distance = (expected.translation() - view.marker.translation()).norm();
    error.largest = std::max(error.largest, distance);
    error.mean += distance / static_cast<double>(views.size());
  }
  return error;
}

/// The arm as a calibration in a world with these errors has measured it.
MeasuredArm calibrated_arm(const ScratchFolder& folder, const std::string& deployment, const std::string& errors,
                           const std::vector<std::string>& options = {}) {
  const auto file = folder / "arm.toml";
  std::vector<std::string> arguments{"calibrate", "kinematics", deployment, "--into", file.string(),
                                     "--errors",  errors,       "--seed",   "1",      "--quiet"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  run_mrroc(arguments, 0);
  return config::load_deployment(with_calibration(folder, kInspect, "inspect.xml", file)).robot("arm").measured_arm;
}

void expect_nearer(const std::string& set, const std::vector<std::string>& options, double part) {
  const ScratchFolder folder;
  TrueArm arm(errors_of(folder, config::errors_set(set), "1"));
  const PlaceError before = error_of_places(arm, {});
  const MeasuredArm measured = calibrated_arm(folder, kInspect, set, options);
  const PlaceError after = error_of_places(arm, measured);
  std::printf("%.3f mm, mean %.3f mm before; %.3f mm, mean %.3f mm after\n", 1000 * before.largest, 1000 * before.mean,
              1000 * after.largest, 1000 * after.mean);
  EXPECT_EQ(measured.links.size(), 6U);
  EXPECT_LT(after.mean, part * before.mean);
  EXPECT_LT(after.largest, part * before.largest);
}

TEST(CalibrateKinematics, AnArmOfALabIsNearerToTheTrueOne) { expect_nearer("modest", {}, 0.3); }

TEST(CalibrateKinematics, AnArmThatWasPutTogetherAgainIsNearerToTheTrueOne) {
  const ScratchFolder folder;
  const auto set = folder.write(
      "worn.toml", "joint_offset = 0.005\nlink_position = 0.001\nlink_rotation = 0.001\npixel_noise = 2\n");
  expect_nearer(set.string(), {"--joint-deviation", "0.003", "--link-deviation", "0.0006", "--views", "40"}, 0.2);
}

/// The camera of an arm as measured is found where that arm computes it, in worlds with errors.
TEST(CalibrateKinematics, ThenTheCameraOnTheArmIsFound) {
  const bool thorough = std::getenv("MRROC_TEST_THOROUGH") != nullptr;
  for (const std::string& seed :
       thorough ? std::vector<std::string>{"1", "2", "3", "4", "5"} : std::vector<std::string>{"2"}) {
    const ScratchFolder folder;
    const config::ErrorsEntry errors = errors_of(folder, config::errors_set("modest"), seed);
    TrueArm arm(errors);
    const std::vector<std::string> world{"--errors", "modest", "--seed", seed, "--quiet"};
    const auto run = [&](const char* kind, const std::string& deployment, const std::string& into,
                         const std::vector<std::string>& options) {
      std::vector<std::string> arguments{"calibrate", kind, deployment, "--into", into};
      for (const auto& more : {world, options}) arguments.insert(arguments.end(), more.begin(), more.end());
      run_mrroc(arguments, 0);
    };
    const std::string arm_file = (folder / "arm.toml").string(), eye_file = (folder / "eye.toml").string();
    run("kinematics", kInspect, arm_file, {});
    const auto calibrated = with_calibration(folder, kInspect, "inspect.xml", arm_file);
    run("hand-eye", calibrated.string(), eye_file, {});
    const MeasuredArm measured = config::load_deployment(calibrated).robot("arm").measured_arm;
    const RobotModels models = kinematics::with_measured(load_irb6(), measured);
    const Pose truth =
        calibration::fit_hand_eye(*models.front(),
                                  arm.exact_views(kNominalEye * sim::error_of_camera(errors, "eye"), measured),
                                  {.joint = 1e-9, .focal = 1e-9, .k1 = 1e-9})
            .camera;
    const config::Table eye = config::Table::load(eye_file).table("sensors").table("eye");
    const Pose found = pose_from_rpy(vector(eye, "mount_position"), vector(eye, "mount_rotation"));
    const double position = (found.translation() - truth.translation()).norm();
    const double rotation = rotation_vector(found.linear().transpose() * truth.linear()).norm();
    std::printf("seed %s: %.3f mm, %.2f mrad\n", seed.c_str(), 1000 * position, 1000 * rotation);
    EXPECT_LT(position, 0.0002);
    EXPECT_LT(rotation, 0.1 * std::numbers::pi / 180);
  }
}

/// What is measured in a deployment that is already calibrated is the whole arm, not the rest.
TEST(CalibrateKinematics, OnceMoreItFindsAnArmThatIsAsGood) {
  const ScratchFolder folder;
  const std::vector<std::string> few{"--views", "24"};
  const MeasuredArm first = calibrated_arm(folder, kInspect, "modest", few);
  const auto kept = folder.write("kept.toml", text_of(folder / "arm.toml"));
  const auto calibrated = with_calibration(folder, kInspect, "inspect.xml", kept);
  const auto kept_deployment = folder.write("again.toml", text_of(calibrated));
  const MeasuredArm second = calibrated_arm(folder, kept_deployment.string(), "modest", few);
  TrueArm arm(errors_of(folder, config::errors_set("modest"), "1"));
  const double before = error_of_places(arm, {}).mean;
  const double once = error_of_places(arm, first).mean, again = error_of_places(arm, second).mean;
  std::printf("mean %.3f mm before, %.3f mm after the first, %.3f mm after the second\n", 1000 * before, 1000 * once,
              1000 * again);
  EXPECT_LT(once, 0.4 * before);
  EXPECT_LT(again, 0.4 * before);
}

}  // namespace
}  // namespace mrroc::test::calibrate_kinematics_test
