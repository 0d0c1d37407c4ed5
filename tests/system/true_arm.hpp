#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "calibration/hand_eye.hpp"
#include "calibration/view_postures.hpp"
#include "config/deployment.hpp"
#include "geometry/rigid_motion.hpp"
#include "kinematics/measured_joints.hpp"
#include "kinematics/measured_model.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sim/errors/true_errors.hpp"
#include "sim/scene/model.hpp"
#include "sim/simulation.hpp"

namespace mrroc::test {

inline constexpr const char* kInspect = MRROC_SOURCE_DIR "/tasks/inspect/inspect.toml";
/// The camera of tasks/inspect on the flange, as deployed.
inline const Pose kNominalEye = pose_from_rpy({0.08, 0.0, 0.06}, {0.0, 0.0, std::numbers::pi / 2});

/// An IRb-6 with the camera of tasks/inspect in a world with errors: its flange, and what its encoders say.
class TrueArm {
 public:
  explicit TrueArm(const config::ErrorsEntry& errors, const std::filesystem::path& file = kInspect,
                   std::string robot = "arm")
      : robot_(std::move(robot)) {
    config::Deployment deployment = config::load_deployment(file);
    deployment.sim->errors = errors;
    for (const AxisParameters& axis : type_->parameters().axes)
      joints_.push_back(sim::errors_of_joint(errors, robot_, axis.name));
    model_ = sim::load_model(sim::compose(deployment));
    data_ = sim::make_data(*model_);
  }

  Pose flange(const JointVector& joints) {
    const auto& axes = type_->parameters().axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, (robot_ + "/" + axes[i].name).c_str());
      data_->qpos[model_->jnt_qposadr[joint]] = joints[static_cast<Eigen::Index>(i)];
    }
    mj_kinematics(model_.get(), data_.get());
    const int body = mj_name2id(model_.get(), mjOBJ_BODY, (robot_ + "/flange").c_str());
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * body);
    pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->xmat + 9 * body);
    return pose;
  }

  /// In the middle of the joints' play.
  JointVector encoders(JointVector joints) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& joint = joints[static_cast<Eigen::Index>(i)];
      joint = joints_[i].reported(joint);
    }
    return joints;
  }

  /// What the robot would see of a marker without any error of the pictures, from other postures than those of a
  /// calibration: by `camera` on the true flange, with the joints of an arm that is known as `measured`.
  std::vector<calibration::MarkerView> exact_views(const Pose& camera, const MeasuredArm& measured = {}) {
    const kinematics::MeasuredJoints found(measured, 6);
    std::vector<calibration::MarkerView> views;
    for (const JointVector& joints : postures()) {
      calibration::MarkerView& view = views.emplace_back();
      view.joints = found.joints(encoders(joints));
      view.marker = (flange(joints) * camera).inverse() * marker();
      view.side = 0.09;
    }
    return views;
  }

  /// Where an arm that is known as `measured` stands by its own account: the pose of its base in the world that brings
  /// points before its camera, as it computes them, nearest to where they are.
  Pose base(const MeasuredArm& measured) {
    const kinematics::MeasuredJoints found(measured, 6);
    const RobotModels models = kinematics::with_measured(load_irb6(), measured);
    std::vector<Eigen::Vector3d> computed, true_places;
    for (const JointVector& joints : postures()) {
      const Pose flange_computed = models.front()->flange(found.joints(encoders(joints))), flange_true = flange(joints);
      for (const Eigen::Vector3d& place : {Eigen::Vector3d(0, 0, 0.2), Eigen::Vector3d(0, 0, 0.5),
                                           Eigen::Vector3d(0.1, 0, 0.4), Eigen::Vector3d(0, 0.1, 0.4)}) {
        computed.push_back(flange_computed * place);
        true_places.push_back(flange_true * place);
      }
    }
    const auto columns = [](const std::vector<Eigen::Vector3d>& places) {
      Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(places.size()));
      for (std::size_t i = 0; i < places.size(); ++i) matrix.col(static_cast<Eigen::Index>(i)) = places[i];
      return matrix;
    };
    return Pose(Eigen::umeyama(columns(computed), columns(true_places), false));
  }

 private:
  /// A marker before the camera at home, in the base frame.
  Pose marker() const {
    return type_->flange(type_->parameters().home) * kNominalEye * Pose(Eigen::Translation3d(0, 0, 0.4)) *
           Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
  }

  /// Other postures than those of the calibration.
  std::vector<JointVector> postures() const {
    calibration::HandEyeFit looking;
    looking.camera = kNominalEye;
    looking.marker = marker();
    return calibration::view_postures(*type_, looking, type_->parameters().home, 100,
                                      {.tilt = 0.5, .turn = 1.2, .nearest = 1.0, .farthest = 1.5, .joint_reach = 2.5});
  }

  std::string robot_;
  std::shared_ptr<const RobotModel> type_ = load_irb6().front();
  sim::Model model_;
  sim::Data data_;
  std::vector<sim::TrueJoint> joints_;
};

}  // namespace mrroc::test
