#pragma once

#include <filesystem>
#include <numbers>

#include "mrroc/robot_model.hpp"
#include "robots/polycrank/kinematics.hpp"

namespace mrroc {

/// The Polycrank: seven axes without joint limits, closed form throughout; kinematics.hpp describes frames, branches
/// and how the redundancy is resolved. The base frame is on the horizontal first axis; a deployment puts it 0.925 m
/// above the floor. Transmission: m = gear q + synchro, one motor per axis. NaN causes an error, never a NaN result; a
/// failed call does not change its outputs.
class PolycrankModel final : public RobotModel {
 public:
  /// `parameters` of seven axes; `geometry` valid as `polycrank::read_geometry` checks it.
  PolycrankModel(RobotParameters parameters, const polycrank::Geometry& geometry);

  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override;
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override;
  JointMatrix transmission(const JointVector& joints) const noexcept override;
  Pose default_tool() const noexcept override { return tool_; }
  Pose flange(const JointVector& joints) const noexcept override;
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override;
  double joint_period(int) const noexcept override { return 2 * std::numbers::pi; }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override;

 private:
  RobotParameters parameters_;
  polycrank::Kinematics kinematics_;
  Pose tool_;
  JointVector gears_;
  JointVector synchro_;  // motor positions at q = 0
};

/// Reads a parameter file of the Polycrank: its one model, "nominal". Throws ConfigurationError. Configuration time
/// only. `file` empty: the
/// installed robots/polycrank/polycrank.toml.
RobotModels load_polycrank(const std::filesystem::path& file = {});

}  // namespace mrroc
