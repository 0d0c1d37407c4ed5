#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// A belt conveyor as an effector with one axis: the travel q (m) of an endless belt, driven by motor = gear q +
/// synchro.
///
/// The base frame is in the belt's surface, in the middle of its width above the axis of the first roller: x along the
/// belt, z up. The flange frame is a mark on the belt that was at the base frame at q = 0: flange(q) is the base frame
/// moved by q along x, even when the mark has passed the last roller. `inverse` accepts the poses on this line,
/// within 1e-6 m and rad; all others, and NaN, are `out_of_workspace`. A failed call does not change its
/// outputs.
class ConveyorModel final : public RobotModel {
 public:
  /// `parameters` of one axis; `gear`: rad of the motor per m of belt, not 0.
  ConveyorModel(RobotParameters parameters, double gear);

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
  double gear_;
  double synchro_;
};

/// Reads a parameter file of the conveyor. Throws ConfigurationError. Configuration time only. `file` empty: the
/// installed robots/conveyor/conveyor.toml.
RobotModels load_conveyor(const std::filesystem::path& file = {});

}  // namespace mrroc
