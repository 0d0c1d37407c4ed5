#pragma once

#include <cmath>
#include <string>

#include "mrroc/robot_model.hpp"

namespace mrroc::fakes {

/// A gantry: axes 0, 1, 2 move the tool along x, y, z; axis 3 turns it about z; further axes do nothing. Motors are 100
/// rad per unit. Limits: +-2, speed 1, acceleration 4, jerk 40, of every axis.
class FakeModel : public RobotModel {
 public:
  explicit FakeModel(int axes) {
    parameters_.type = "fake";
    parameters_.home = JointVector::Zero(axes);
    for (int i = 0; i < axes; ++i) {
      AxisParameters axis;
      axis.name = "axis" + std::to_string(i);
      axis.position_min = -2;
      axis.position_max = 2;
      axis.velocity_max = 1;
      axis.acceleration_max = 4;
      axis.jerk_max = 40;
      axis.motor_min = -200;
      axis.motor_max = 200;
      parameters_.axes.push_back(axis);
    }
  }

  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    joints = motors / 100;
    return ErrorCode::none;
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    motors = joints * 100;
    return ErrorCode::none;
  }
  JointMatrix transmission(const JointVector& joints) const noexcept override {
    return 100 * JointMatrix::Identity(joints.size(), joints.size());
  }
  Pose flange(const JointVector& joints) const noexcept override {
    Pose pose = Pose::Identity();
    for (Eigen::Index i = 0; i < std::min<Eigen::Index>(3, joints.size()); ++i) pose.translation()[i] = joints[i];
    if (joints.size() > 3) pose.linear() = Eigen::AngleAxisd(joints[3], Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return pose;
  }
  /// Outside the workspace: the tool's z axis would have to tilt, or an axis is missing.
  ErrorCode inverse(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept override {
    joints = near;
    for (Eigen::Index i = 0; i < 3; ++i) {
      if (i < joints.size()) joints[i] = pose.translation()[i];
      if (i >= joints.size() && pose.translation()[i] != 0) return ErrorCode::out_of_workspace;
    }
    if (joints.size() > 3) joints[3] = std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
    return flange(joints).isApprox(pose, 1e-9) ? ErrorCode::none : ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d&) const noexcept override {
    Jacobian jacobian = Jacobian::Zero(6, joints.size());
    for (Eigen::Index i = 0; i < std::min<Eigen::Index>(3, joints.size()); ++i) jacobian(i, i) = 1;
    if (joints.size() > 3) jacobian(5, 3) = 1;
    return jacobian;
  }

 protected:
  RobotParameters parameters_;
};

}  // namespace mrroc::fakes
