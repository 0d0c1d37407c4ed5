#pragma once

#include <cmath>

#include "mrroc/robot_model.hpp"

namespace mrroc::sim {

/// The two-link test arm with a transmission that is neither linear nor uncoupled:
///   m1 = 100 q1 + 20 sin q1,   m2 = 80 q2 + 15 q2^2 - 40 q1.
class BentModel : public RobotModel {
 public:
  BentModel() {
    parameters_.type = "twolink";
    parameters_.home = JointVector::Zero(2);
    for (const double increments : {4000.0, 2000.0}) {
      AxisParameters axis;
      axis.name = parameters_.axes.empty() ? "shoulder" : "elbow";
      axis.encoder_increments = increments;
      axis.current_max = 10;
      axis.torque_constant = 0.1 + 0.01 * static_cast<double>(parameters_.axes.size());
      axis.rotor_inertia = 1.5e-4;
      axis.viscous_friction = 1e-3;
      parameters_.axes.push_back(axis);
    }
  }
  /// Without viscous friction, so that the energy is constant.
  void take_friction_away() {
    for (AxisParameters& axis : parameters_.axes) axis.viscous_friction = 0;
  }

  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector&, JointVector&) const noexcept override {
    return ErrorCode::motor_limit;  // the driver does not use them
  }
  ErrorCode joints_to_motors(const JointVector& q, JointVector& motors) const noexcept override {
    if (std::abs(q[1]) > 10) return ErrorCode::joint_limit;
    motors.resize(2);
    motors << 100 * q[0] + 20 * std::sin(q[0]), 80 * q[1] + 15 * q[1] * q[1] - 40 * q[0];
    return ErrorCode::none;
  }
  JointMatrix transmission(const JointVector& q) const noexcept override {
    JointMatrix g(2, 2);
    g << 100 + 20 * std::cos(q[0]), 0, -40, 80 + 30 * q[1];
    return g;
  }
  /// dG/dt, exactly.
  JointMatrix transmission_rate(const JointVector& q, const JointVector& v) const {
    JointMatrix rate(2, 2);
    rate << -20 * std::sin(q[0]) * v[0], 0, 0, 30 * v[1];
    return rate;
  }
  Pose flange(const JointVector&) const noexcept override { return Pose::Identity(); }
  ErrorCode inverse(const Pose&, const JointVector&, JointVector&) const noexcept override {
    return ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector&, const Eigen::Vector3d&) const noexcept override { return Jacobian::Zero(6, 2); }

 private:
  RobotParameters parameters_;
};

}  // namespace mrroc::sim
