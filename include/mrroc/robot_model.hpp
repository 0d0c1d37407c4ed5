#pragma once

#include "mrroc/errors.hpp"
#include "mrroc/robot_parameters.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// Geometry of one robot type: motor <-> joint <-> tool pose. Every method is const, allocates nothing, never throws
/// and may be called from any thread, the servo thread included. Poses are of the tool frame in the robot's base frame.
class RobotModel {
 public:
  virtual ~RobotModel() = default;

  virtual const RobotParameters& parameters() const noexcept = 0;
  int joint_count() const noexcept { return static_cast<int>(parameters().axes.size()); }

  /// Motor shafts (rad) to joints. `none`, or `motor_limit` when no joint position belongs to `motors`.
  virtual ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept = 0;
  /// Joints to motor shafts (rad). `none`, or `joint_limit` when the transmission cannot reach `joints`.
  virtual ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept = 0;
  /// G(q) = d motors / d joints, rad/rad or rad/m; motor velocities are G dq/dt, joint torques G^T (motor torques).
  virtual JointMatrix transmission(const JointVector& joints) const noexcept = 0;

  /// Tool pose of `joints`.
  virtual Pose direct(const JointVector& joints) const noexcept = 0;
  /// Joints of `pose` on the branch nearest to `near`. `none`, `out_of_workspace`, or `singular` (then `joints` still
  /// holds a solution, with the free angle kept from `near`). Joint limits are not looked at.
  virtual ErrorCode inverse(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept = 0;
  /// Geometric Jacobian of the tool frame's origin in base axes.
  virtual Jacobian jacobian(const JointVector& joints) const noexcept = 0;
};

}  // namespace mrroc
