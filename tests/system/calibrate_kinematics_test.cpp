// `mrroc calibrate kinematics` in a world with errors: the arm as measured against the true one.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <memory>
#include <numbers>

#include "calibration/hand_eye.hpp"
#include "calibration/view_postures.hpp"
#include "config/deployment.hpp"
#include "geometry/rigid_motion.hpp"
#include "kinematics/measured_model.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sim/errors/true_errors.hpp"
#include "sim/scene/model.hpp"
#include "sim/simulation.hpp"
#include "system/calibration_files.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::calibrate_kinematics_test {
namespace {

constexpr const char* kInspect = MRROC_SOURCE_DIR "/tasks/inspect/inspect.toml";

/// The arm of a world with errors: its flange, and what its encoders say.
class TrueArm {
 public:
  TrueArm(config::Deployment deployment, const config::ErrorsEntry& errors) {
    deployment.sim->errors = errors;
    for (const AxisParameters& axis : type_->parameters().axes)
      joints_.push_back(sim::errors_of_joint(errors, "arm", axis.name));
    model_ = sim::load_model(sim::compose(deployment));
    data_ = sim::make_data(*model_);
  }

  Pose flange(const JointVector& joints) {
    const auto& axes = type_->parameters().axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, ("arm/" + axes[i].name).c_str());
      data_->qpos[model_->jnt_qposadr[joint]] = joints[static_cast<Eigen::Index>(i)];
    }
    mj_kinematics(model_.get(), data_.get());
    const int site = mj_name2id(model_.get(), mjOBJ_SITE, "arm/wrist");
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Map<const Eigen::Vector3d>(data_->site_xpos + 3 * site);
    pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->site_xmat + 9 * site);
    return pose;
  }

  JointVector encoders(JointVector joints) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& joint = joints[static_cast<Eigen::Index>(i)];
      joint = joints_[i].reported(joint);
    }
    return joints;
  }

 private:
  std::shared_ptr<const RobotModel> type_ = load_irb6().front();
  sim::Model model_;
  sim::Data data_;
  std::vector<sim::TrueJoint> joints_;
};

/// How far from where it is the arm expects a marker before its camera, m, after a hand-eye calibration with exact
/// pictures: what is left of the arm's own errors.
struct PlaceError {
  double largest = 0, mean = 0;
};

PlaceError error_of_places(TrueArm& arm, const MeasuredArm& measured) {
  const RobotModels nominal = load_irb6(), models = kinematics::with_measured(nominal, measured);
  const RobotModel &type = *nominal.front(), &model = *models.front();
  const JointVector zeros = measured.zeros.size() != 0 ? measured.zeros : JointVector(JointVector::Zero(6));
  const Pose camera = pose_from_rpy({0.08, 0.0, 0.06}, {0.0, 0.0, std::numbers::pi / 2});
  calibration::HandEyeFit looking;
  looking.camera = camera;
  looking.marker = type.flange(type.parameters().home) * camera * Pose(Eigen::Translation3d(0, 0, 0.4)) *
                   Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
  // other postures than those of the calibration
  const auto postures = calibration::view_postures(type, looking, type.parameters().home, 100,
                                                   {.tilt = 0.5, .turn = 1.2, .farthest = 1.5, .joint_reach = 2.5});
  std::vector<calibration::MarkerView> views;
  for (const JointVector& joints : postures) {
    calibration::MarkerView& view = views.emplace_back();
    view.joints = arm.encoders(joints) + zeros;
    view.marker = (arm.flange(joints) * camera).inverse() * looking.marker;
    view.side = 0.09;
  }
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
  TrueArm arm(config::load_deployment(kInspect), errors_of(folder, config::errors_set(set), "1"));
  const PlaceError before = error_of_places(arm, {});
  const MeasuredArm measured = calibrated_arm(folder, kInspect, set, options);
  const PlaceError after = error_of_places(arm, measured);
  std::printf("%.3f mm, mean %.3f mm before; %.3f mm, mean %.3f mm after\n", 1000 * before.largest, 1000 * before.mean,
              1000 * after.largest, 1000 * after.mean);
  EXPECT_EQ(measured.links.size(), 6U);
  EXPECT_LT(after.mean, part * before.mean);
  EXPECT_LT(after.largest, part * before.largest);
}

TEST(CalibrateKinematics, AnArmOfALabIsNearerToTheTrueOne) { expect_nearer("modest", {}, 0.6); }

TEST(CalibrateKinematics, AnArmThatWasPutTogetherAgainIsNearerToTheTrueOne) {
  const ScratchFolder folder;
  const auto set = folder.write(
      "worn.toml", "joint_offset = 0.005\nlink_position = 0.001\nlink_rotation = 0.001\npixel_noise = 2\n");
  expect_nearer(set.string(), {"--joint-deviation", "0.003", "--link-deviation", "0.0006", "--views", "40"}, 0.2);
}

/// What is measured in a deployment that is already calibrated is the whole arm, not the rest.
TEST(CalibrateKinematics, OnceMoreItFindsTheSame) {
  const ScratchFolder folder;
  const std::vector<std::string> few{"--views", "24"};
  const MeasuredArm first = calibrated_arm(folder, kInspect, "modest", few);
  const auto kept = folder.write("kept.toml", text_of(folder / "arm.toml"));
  const auto calibrated = with_calibration(folder, kInspect, "inspect.xml", kept);
  const auto again = folder.write("again.toml", text_of(calibrated));
  const MeasuredArm second = calibrated_arm(folder, again.string(), "modest", few);
  EXPECT_LT((first.zeros - second.zeros).cwiseAbs().maxCoeff(), 2e-4);
  EXPECT_GT(first.zeros.cwiseAbs().maxCoeff(), 4e-4);
}

}  // namespace
}  // namespace mrroc::test::calibrate_kinematics_test
