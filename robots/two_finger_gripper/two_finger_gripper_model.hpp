#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"
#include "robots/two_finger_gripper/transmission.hpp"

namespace mrroc {

/// The IRb-6's two-finger gripper as an effector with one axis: the opening q, the clear width between the two pads
/// (m), which one servo changes through a non-linear transmission; each finger moves q / 2.
///
/// The base frame is in the mounting face: z towards the part, the fingers move along x. The flange frame is on the
/// first finger's pad, in the middle of its gripping surface, its axes as the base's: flange(q) = (q / 2, 0, reach).
/// `inverse` accepts the poses on this line, within 1e-6 m and rad; all others, and NaN, are `out_of_workspace`.
/// A failed call does not change its outputs.
class TwoFingerGripperModel final : public RobotModel {
 public:
  /// `parameters` of one axis; `geometry` valid as `two_finger_gripper::read_geometry` checks it.
  TwoFingerGripperModel(RobotParameters parameters, const two_finger_gripper::Geometry& geometry);

  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override;
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override;
  JointMatrix transmission(const JointVector& joints) const noexcept override;
  Pose flange(const JointVector& joints) const noexcept override;
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override;
  /// The pose on the line that is nearest to any other one.
  void branches(const Pose& flange, const JointVector& near, BranchReceiver& receiver) const noexcept override;
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override;

 private:
  RobotParameters parameters_;
  two_finger_gripper::Transmission transmission_;
  double reach_;
};

/// Reads a parameter file of the gripper. Throws ConfigurationError. Configuration time only. `file` empty: the
/// installed robots/two_finger_gripper/two_finger_gripper.toml.
RobotModels load_two_finger_gripper(const std::filesystem::path& file = {});

}  // namespace mrroc
