#pragma once

#include <algorithm>
#include <cmath>

#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// One axis with the original's numbers of the IRp-6 column: regulator, motor, encoder.
inline AxisParameters test_axis(const char* name) {
  AxisParameters axis;
  axis.name = name;
  axis.position_min = -2;
  axis.position_max = 2;
  axis.velocity_max = 0.8;
  axis.acceleration_max = 8;
  axis.jerk_max = 4000;  // so high that tests of the other limits meet those
  axis.motor_min = -250;
  axis.motor_max = 250;
  axis.encoder_increments = 4000;
  axis.current_max = 20;
  axis.following_error_max = 30;
  axis.stuck_max = 0.08 * axis.following_error_max;  // the default of a robot's file
  axis.stuck_current = 0;
  axis.regulator_a = 0.412429378531;
  axis.regulator_b0 = 2.594932 * 0.6;
  axis.regulator_b1 = 2.504769 * 0.6;
  axis.regulator_eps = 0.010;
  axis.regulator_output_max = 190;
  axis.regulator_current_gain = 0.2;
  axis.torque_constant = 0.105;
  axis.rotor_inertia = 1.5e-4;
  axis.viscous_friction = 0.02;
  return axis;
}

/// Robot with a gear of 100 per axis.
class GearedModel : public RobotModel {
 public:
  const RobotParameters& parameters() const noexcept override { return parameters_; }
  RobotParameters& change() noexcept { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    joints = motors / kGear;
    return ErrorCode::none;
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    motors = kGear * joints;
    return ErrorCode::none;
  }
  JointMatrix transmission(const JointVector& joints) const noexcept override {
    return kGear * JointMatrix::Identity(joints.size(), joints.size());
  }
  static constexpr double kGear = 100;

 protected:
  RobotParameters parameters_;
};

/// One slide along x.
class Slide : public GearedModel {
 public:
  Slide() {
    parameters_.type = "slide";
    parameters_.axes = {test_axis("x")};
    parameters_.home = JointVector::Constant(1, 0.25);
  }
  Pose flange(const JointVector& joints) const noexcept override { return Pose(Eigen::Translation3d(joints[0], 0, 0)); }
  ErrorCode inverse(const Pose& pose, const JointVector&, JointVector& joints) const noexcept override {
    joints = JointVector::Constant(1, pose.translation().x());
    return flange(joints).isApprox(pose, 1e-9) ? ErrorCode::none : ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector&, const Eigen::Vector3d&) const noexcept override {
    Jacobian jacobian = Jacobian::Zero(6, 1);
    jacobian(0, 0) = 1;
    return jacobian;
  }
};

/// Three slides x, y, z and a rotation about z.
class Gantry : public GearedModel {
 public:
  Gantry() {
    parameters_.type = "gantry";
    parameters_.axes = {test_axis("x"), test_axis("y"), test_axis("z"), test_axis("yaw")};
    parameters_.home = JointVector::Zero(4);
  }
  Pose flange(const JointVector& joints) const noexcept override {
    return Eigen::Translation3d(joints[0], joints[1], joints[2]) *
           Pose(Eigen::AngleAxisd(joints[3], Eigen::Vector3d::UnitZ()));
  }
  ErrorCode inverse(const Pose& pose, const JointVector&, JointVector& joints) const noexcept override {
    joints.resize(4);
    joints << pose.translation(), std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
    return flange(joints).isApprox(pose, 1e-9) ? ErrorCode::none : ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector&, const Eigen::Vector3d&) const noexcept override {
    Jacobian jacobian = Jacobian::Zero(6, 4);
    jacobian.topLeftCorner<3, 3>().setIdentity();
    jacobian(5, 3) = 1;
    return jacobian;
  }
};

/// Planar arm of two links, 0.5 m and 0.4 m, elbow up or down as in `near`.
class PlanarArm : public GearedModel {
 public:
  PlanarArm() {
    parameters_.type = "planar_arm";
    parameters_.axes = {test_axis("shoulder"), test_axis("elbow")};
    parameters_.home = (JointVector(2) << 0.3, 0.9).finished();
  }
  Pose flange(const JointVector& joints) const noexcept override {
    const double a = joints[0], b = joints[0] + joints[1];
    return Eigen::Translation3d(kUpper * std::cos(a) + kFore * std::cos(b), kUpper * std::sin(a) + kFore * std::sin(b),
                                0) *
           Pose(Eigen::AngleAxisd(b, Eigen::Vector3d::UnitZ()));
  }
  ErrorCode inverse(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept override {
    const double x = pose.translation().x(), y = pose.translation().y();
    const double cosine = (x * x + y * y - kUpper * kUpper - kFore * kFore) / (2 * kUpper * kFore);
    if (!(std::abs(cosine) <= 1)) return ErrorCode::out_of_workspace;
    const double elbow = std::copysign(std::acos(cosine), near[1]);
    joints.resize(2);
    joints << std::atan2(y, x) - std::atan2(kFore * std::sin(elbow), kUpper + kFore * std::cos(elbow)), elbow;
    return flange(joints).isApprox(pose, 1e-9) ? ErrorCode::none : ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d&) const noexcept override {
    const double a = joints[0], b = joints[0] + joints[1];
    Jacobian jacobian = Jacobian::Zero(6, 2);
    jacobian(0, 0) = -kUpper * std::sin(a) - kFore * std::sin(b);
    jacobian(1, 0) = kUpper * std::cos(a) + kFore * std::cos(b);
    jacobian(0, 1) = -kFore * std::sin(b);
    jacobian(1, 1) = kFore * std::cos(b);
    jacobian(5, 0) = jacobian(5, 1) = 1;
    return jacobian;
  }
  static constexpr double kUpper = 0.5, kFore = 0.4;
};

/// Three axes that cross: yaw, pitch, yaw. Without pitch it cannot turn about the axis at right angles to both.
class Wrist : public GearedModel {
 public:
  Wrist() {
    parameters_.type = "wrist";
    parameters_.axes = {test_axis("yaw"), test_axis("pitch"), test_axis("roll")};
    parameters_.home = (JointVector(3) << 0, 0.001, 0).finished();
  }
  Pose flange(const JointVector& joints) const noexcept override {
    return Pose(yaw(joints[0]) * pitch(joints[1]) * yaw(joints[2]));
  }
  ErrorCode inverse(const Pose& pose, const JointVector&, JointVector& joints) const noexcept override {
    joints = pose.linear().eulerAngles(2, 1, 2);
    return flange(joints).isApprox(pose, 1e-9) ? ErrorCode::none : ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d&) const noexcept override {
    Jacobian jacobian = Jacobian::Zero(6, 3);
    jacobian.bottomRows<3>() << Eigen::Vector3d::UnitZ(), yaw(joints[0]) * Eigen::Vector3d::UnitY(),
        yaw(joints[0]) * pitch(joints[1]) * Eigen::Vector3d::UnitZ();
    return jacobian;
  }

 private:
  static Eigen::AngleAxisd yaw(double angle) { return {angle, Eigen::Vector3d::UnitZ()}; }
  static Eigen::AngleAxisd pitch(double angle) { return {angle, Eigen::Vector3d::UnitY()}; }
};

}  // namespace mrroc::edp
