#pragma once

#include <filesystem>

#include "mrroc/robot_model.hpp"
#include "robots/irb6/kinematics.hpp"
#include "robots/irb6/transmission.hpp"

namespace mrroc {

/// The IRb-6 on its post with six axes, all in closed form. The base frame is at shoulder height, above the post: z up,
/// x forward at joint 1 = 0; a deployment puts it 0.7 m above the floor. `joints_to_motors` and `motors_to_joints` look
/// at what the transmission can do, not at the limits of `parameters()`. Garbage gets an error, never a NaN: outputs of
/// a failed call are left as they were. The branches are told in kinematics.hpp.
class Irb6Model final : public RobotModel {
 public:
  /// `parameters` of six axes; `geometry` valid as `irb6::read_geometry` checks it.
  Irb6Model(RobotParameters parameters, const irb6::Geometry& geometry);

  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override;
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override;
  JointMatrix transmission(const JointVector& joints) const noexcept override;
  Pose default_tool() const noexcept override { return tool_; }
  Pose flange(const JointVector& joints) const noexcept override { return kinematics_.flange(joints); }
  ErrorCode inverse(const Pose& flange, const JointVector& near, JointVector& joints) const noexcept override {
    return kinematics_.inverse(flange, near, joints);
  }
  Jacobian jacobian(const JointVector& joints, const Eigen::Vector3d& offset) const noexcept override {
    return kinematics_.jacobian(joints, offset);
  }

 private:
  RobotParameters parameters_;
  irb6::Transmission transmission_;
  irb6::Kinematics kinematics_;
  Pose tool_;
};

/// Reads a parameter file of the IRb-6. Throws ConfigurationError. Configuration time only.
RobotModels load_irb6(const std::filesystem::path& file);

/// The same of the installed robots/irb6/irb6.toml.
RobotModels load_irb6();

}  // namespace mrroc
