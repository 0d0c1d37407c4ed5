// `mrroc calibrate` in worlds with errors: the result against the truth, and a task before and after it.
#include <gtest/gtest.h>

#include <numbers>

#include "config/entries/errors_entry.hpp"
#include "config/table.hpp"
#include "replace.hpp"
#include "system/calibration_files.hpp"
#include "system/mrroc_run.hpp"
#include "system/true_arm.hpp"

namespace mrroc::test::calibrate_test {
namespace {

constexpr const char* kForceDemo = MRROC_SOURCE_DIR "/sensors/force_torque/demo.toml";

TEST(CalibrateLoad, TaskFailsBeforeAndSucceedsAfterIt) {
  for (const std::string seed : {"1", "2", "3"}) {
    SCOPED_TRACE("seed " + seed);
    const ScratchFolder folder;
    const std::vector<std::string> errors{"--errors", "modest", "--seed", seed, "--quiet"};
    const auto run = [&](const std::string& file, int expected) {
      std::vector<std::string> arguments{"run", file, "--black-box", ""};
      arguments.insert(arguments.end(), errors.begin(), errors.end());
      run_mrroc(arguments, expected);
    };
    run(kForceDemo, 1);
    const auto file = folder / "wrist.toml";
    std::vector<std::string> arguments{"calibrate", "load",   kForceDemo,    "--sensor",
                                       "wrist",     "--into", file.string(), "--speed=0.8"};
    arguments.insert(arguments.end(), errors.begin(), errors.end());
    run_mrroc(arguments, 0);
    const config::Table wrist = config::Table::load(file).table("sensors").table("wrist");
    std::printf("seed %s: mass %.4f kg, centre (%.2f, %.2f, %.2f) mm\n", seed.c_str(), wrist.number("tool_mass"),
                1000 * vector(wrist, "tool_centre").x(), 1000 * vector(wrist, "tool_centre").y(),
                1000 * vector(wrist, "tool_centre").z());
    // the MJCF's tool
    EXPECT_NEAR(wrist.number("tool_mass"), 1.1, 0.01);
    EXPECT_LT((vector(wrist, "tool_centre") - Eigen::Vector3d(0.004, 0, 0.066)).norm(), 0.0005);
    run(with_calibration(folder, kForceDemo, "demo.xml", file).string(), 0);
  }
}

TEST(CalibrateLoad, RefusedResultWritesNoFile) {
  const ScratchFolder folder;
  const auto file = folder / "wrist.toml";
  const std::string output = run_mrroc({"calibrate", "load", kForceDemo, "--sensor", "wrist", "--into", file.string(),
                                        "--errors", "modest", "--force-bound", "0.001", "--postures", "6", "--quiet"},
                                       1);
  EXPECT_NE(output.find("the calibration is refused: force residual"), std::string::npos) << output;
  EXPECT_NE(output.find("(at most 0.001 N)"), std::string::npos) << output;
  EXPECT_FALSE(std::filesystem::exists(file));
}

/// Where the camera is on the flange as an arm with errors computes it: what a calibration is to find, here from
/// exact pictures. Errors of the arm's last link and joint are in it.
Pose true_eye(const config::ErrorsEntry& errors) {
  const Pose on_flange = kNominalEye * sim::error_of_camera(errors, "eye");
  const auto views = TrueArm(errors).exact_views(on_flange);
  return calibration::fit_hand_eye(*load_irb6().front(), views, {.joint = 1e-9, .focal = 1e-9, .k1 = 1e-9}).camera;
}

/// How far a camera found in a world with these errors is from the true one.
struct EyeError {
  double position = 0, rotation = 0, focal = 0;  // m, rad, 1
  double position_before = 0, rotation_before = 0;
  double reading = 0, reading_before = 0;  ///< of the position of a thing 0.35 m ahead, m
};

EyeError calibrated_eye(const ScratchFolder& folder, const std::string& errors, const std::string& seed) {
  const auto file = folder / "eye.toml";
  std::vector<std::string> arguments{"calibrate", "hand-eye", kInspect, "--into", file.string(),
                                     "--errors",  errors,     "--seed", seed,     "--quiet"};
  if (errors != "modest") arguments.insert(arguments.end(), {"--joint-deviation", "1e-6", "--arm-deviation", "1e-5"});
  run_mrroc(arguments, 0);
  const config::Table eye = config::Table::load(file).table("sensors").table("eye");
  const Pose found = pose_from_rpy(vector(eye, "mount_position"), vector(eye, "mount_rotation"));
  const config::ErrorsEntry sizes = errors_of(folder, config::errors_set(errors), seed);
  const Pose truth = true_eye(sizes);
  const auto angle = [](const Pose& a, const Pose& b) {
    return rotation_vector(a.linear().transpose() * b.linear()).norm();
  };
  const double focal = sim::error_of_lens(sizes, "eye").focal, scale = eye.number("focal_scale");
  const auto reading = [&](const Pose& camera, double used) {  // the depth is proportional to the focal length used
    return (camera * Eigen::Vector3d(0, 0, 0.35 * used / (1 + focal)) - truth * Eigen::Vector3d(0, 0, 0.35)).norm();
  };
  const EyeError error{(found.translation() - truth.translation()).norm(),
                       angle(found, truth),
                       scale - 1 - focal,
                       (kNominalEye.translation() - truth.translation()).norm(),
                       angle(kNominalEye, truth),
                       reading(found, scale),
                       reading(kNominalEye, 1)};
  std::printf(
      "%s, seed %s: %.3f mm, %.2f mrad before; %.3f mm, %.2f mrad, focal length %.5f after; readings %.3f and %.3f "
      "mm\n",
      errors.c_str(), seed.c_str(), 1000 * error.position_before, 1000 * error.rotation_before, 1000 * error.position,
      1000 * error.rotation, error.focal, 1000 * error.reading_before, 1000 * error.reading);
  return error;
}

TEST(CalibrateHandEye, FindsTheCameraOnAnExactArm) {
  const ScratchFolder folder;
  const auto errors = folder.write("camera.toml",
                                   "camera_position = 0.001\ncamera_rotation = 0.002\nfocal_length = 0.003\n"
                                   "distortion = 0.01\npixel_noise = 2\nblur = 0.5\n");
  for (const std::string seed : {"1", "2", "3"}) {
    const EyeError error = calibrated_eye(folder, errors.string(), seed);
    EXPECT_LT(error.position, 0.00015);
    EXPECT_LT(error.reading, 0.1 * error.reading_before);
    EXPECT_LT(error.rotation, 0.1 * std::numbers::pi / 180);
  }
}

TEST(CalibrateHandEye, FindsTheCameraOnAnArmWithErrors) {
  for (const std::string seed : {"1", "2", "3"}) {
    const ScratchFolder folder;
    const EyeError error = calibrated_eye(folder, "modest", seed);
    EXPECT_LT(error.position, 0.0004);
    EXPECT_LT(error.reading, 0.3 * error.reading_before);
    EXPECT_LT(error.rotation, 0.1 * std::numbers::pi / 180);
  }
}

TEST(Calibrate, WrongArgumentsAreNamedBeforeAnythingStarts) {
  const ScratchFolder folder;
  const std::string into = (folder / "a.toml").string();
  const auto refusal = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "calibrate");
    return run_mrroc(arguments, 2);
  };
  EXPECT_NE(refusal({"load", kForceDemo, "--into", into}).find("--sensor"), std::string::npos) << "there are two";
  EXPECT_NE(refusal({"load", kForceDemo, "--into", into, "--sensor", "wirst"}).find("'wirst', expected 'wrist'"),
            std::string::npos);
  EXPECT_NE(refusal({"load", kForceDemo, "--into", into, "--robot", "left"}).find("'left', expected 'arm'"),
            std::string::npos);
  EXPECT_NE(
      refusal({"load", kForceDemo, "--sensor", "plain", "--into", "/nowhere/a.toml"}).find("no folder '/nowhere'"),
      std::string::npos);
  EXPECT_NE(refusal({"weight", kForceDemo, "--into", into})
                .find("no kind 'weight', expected 'load', 'hand-eye', 'base', 'kinematics' or 'camera'"),
            std::string::npos);
  EXPECT_NE(refusal({"load", kForceDemo, "--into", into, "--reach", "9"}).find("expected a number from 0.05 to 3"),
            std::string::npos);
  EXPECT_NE(refusal({"load", MRROC_SOURCE_DIR "/tasks/pick/pick.toml", "--into", into})
                .find("the deployment has no robot with a sensor of type 'force_torque'"),
            std::string::npos);
  EXPECT_NE(refusal({"camera", MRROC_SOURCE_DIR "/tasks/inspect/inspect.toml", "--into", into})
                .find("the deployment has no robot beside a sensor of type 'camera' that does not move"),
            std::string::npos);
  EXPECT_NE(refusal({"base", MRROC_SOURCE_DIR "/tasks/inspect/inspect.toml", "--into", into, "--x", "1"}).find("--y"),
            std::string::npos)
      << "the marker's place has no default";
  // only calibration files are replaced
  const std::string notes = folder.write("notes.txt", "precious").string();
  std::string cell = text_of(kForceDemo);
  replace(cell, "\"demo.xml\"", "'" MRROC_SOURCE_DIR "/sensors/force_torque/demo.xml'");
  for (const std::string& target : {notes, folder.write("cell.toml", cell).string()})
    EXPECT_NE(refusal({"load", target == notes ? kForceDemo : target, "--sensor", "wrist", "--into", target})
                  .find("exists and is no calibration file"),
              std::string::npos);
  EXPECT_EQ(text_of(notes), "precious");
  EXPECT_NE(refusal({"load", kForceDemo, "--sensor", "wrist", "--into", "/proc/a.toml"}).find("cannot be written"),
            std::string::npos);
  EXPECT_NE(refusal({"base", MRROC_SOURCE_DIR "/tasks/inspect/inspect.toml", "--into", into, "--roll", "9"})
                .find("expected a number from -6.28"),
            std::string::npos);
}

}  // namespace
}  // namespace mrroc::test::calibrate_test
