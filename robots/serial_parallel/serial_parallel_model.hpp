#pragma once

#include <filesystem>
#include <numbers>

#include "mrroc/robot_model.hpp"
#include "robots/serial_parallel/kinematics.hpp"

namespace mrroc {

/// A tripod with a wrist that hangs in a portal and carries a milling spindle. Joints: leg_a, leg_b, leg_c (m),
/// wrist_turn, wrist_bend, wrist_roll (rad); the base frame is on the common axis of legs A and C, z up
/// (kinematics.hpp). Each motor drives one joint: motor = gear (joint - synchro position) with the file's gears.
///
/// Joints with a passive joint more than `kOvershoot` beyond its limit have no motors (`joint_limit`): so no path leads
/// through them, while a robot at a limit may overshoot it. `inverse`, which paths of the tool follow, grants no
/// overshoot; `branches` grants it. NaN causes an error, never a NaN result: a failed call does not change its outputs.
class SerialParallelModel final : public RobotModel {
 public:
  /// `parameters` of six axes; `geometry` valid as `serial_parallel::read_geometry` checks it.
  SerialParallelModel(RobotParameters parameters, const serial_parallel::Geometry& geometry);

  static constexpr double kOvershoot = 0.0175;  ///< rad

  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override;
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override;
  JointMatrix transmission(const JointVector&) const noexcept override { return gears_.asDiagonal(); }
  Pose default_tool() const noexcept override { return tool_; }
  Pose flange(const JointVector& joints) const noexcept override { return kinematics_.flange(joints); }
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override {
    return kinematics_.inverse(flange, near, joints);
  }
  void branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept override {
    kinematics_.branches(flange, near, kOvershoot, receiver);
  }
  std::string_view branch_name(const JointVector& joints) const noexcept override {
    return joints[4] < 0 ? "wrist bend < 0" : "wrist bend >= 0";
  }
  double joint_period(int joint) const noexcept override { return joint < 3 ? 0 : 2 * std::numbers::pi; }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override {
    return kinematics_.jacobian(joints, offset);
  }
  /// The URDF's passive joints swing_*, lean_*, pitch_b, tilt_a; the heads of legs B and C at the platform.
  ClosedLoops closed_loops(const JointVector& joints) const override;

 private:
  RobotParameters parameters_;
  serial_parallel::Kinematics kinematics_;
  JointVector gears_;
  JointVector synchro_motors_;
  JointVector synchro_joints_;
  Pose tool_;
};

/// Reads a parameter file of this robot. Throws ConfigurationError. Configuration time only. `file` empty: the
/// installed robots/serial_parallel/serial_parallel.toml.
RobotModels load_serial_parallel(const std::filesystem::path& file = {});

}  // namespace mrroc
