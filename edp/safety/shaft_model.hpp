#pragma once

#include <cmath>

#include "mrroc/robot_model.hpp"
#include "mrroc/search_speed.hpp"

namespace mrroc::edp {

/// The model of a robot whose joint positions are still unknown: its "joints" are the motor shafts, counted from
/// power-on. Limits: slow motion, no positions. It has no poses.
class ShaftModel final : public RobotModel {
 public:
  explicit ShaftModel(const RobotParameters& robot) : parameters_(robot) {
    for (AxisParameters& axis : parameters_.axes) {
      axis.position_min = axis.motor_min = -HUGE_VAL;
      axis.position_max = axis.motor_max = HUGE_VAL;
      axis.velocity_max = search_speed(axis);
      axis.acceleration_max = kAccelerationRate * axis.velocity_max;
      axis.jerk_max = kJerkRate * axis.acceleration_max;
    }
    parameters_.home.setZero();
  }

  std::string_view name() const noexcept override { return "shafts"; }
  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    joints = motors;
    return ErrorCode::none;
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    motors = joints;
    return ErrorCode::none;
  }
  JointMatrix transmission(const JointVector& joints) const noexcept override {
    return JointMatrix::Identity(joints.size(), joints.size());
  }
  Pose flange(const JointVector&) const noexcept override { return Pose::Identity(); }
  ErrorCode inverse(const Pose&, const JointVector&, JointVector&) const noexcept override {
    return ErrorCode::not_synchronised;
  }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d&) const noexcept override {
    return Jacobian::Zero(6, joints.size());
  }

 private:
  static constexpr double kAccelerationRate = 5;  // 1/s: full speed within a fifth of a second
  static constexpr double kJerkRate = 25;         // 1/s
  RobotParameters parameters_;
};

}  // namespace mrroc::edp
