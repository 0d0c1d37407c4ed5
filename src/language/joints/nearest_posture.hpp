#pragma once

#include "mrroc/tool_kinematics.hpp"

/// The posture that a motion in joint space takes for a tool pose. Any thread; never allocates or throws.
namespace mrroc {

/// Tolerances of a posture's tool pose from the requested pose, when no posture has that pose exactly.
inline constexpr double kPositionTolerance = 1e-3;  ///< m
inline constexpr double kRotationTolerance = 5e-3;  ///< rad

PoseDeviation deviation(const Pose& from, const Pose& to) noexcept;

/// The result of `nearest_posture`.
struct Posture {
  JointVector joints;
  PoseDeviation deviation;  ///< of its tool pose from the requested one; 0 when it has that pose
  /// Without a posture: `joint_limit`, `motor_limit` (branches exist, but all of them pass a limit; `joints`, `axis`,
  /// `value` are those of the nearest one), `out_of_workspace` (no branch exists, or the nearest pose is `deviation`
  /// off).
  ErrorCode code = ErrorCode::none;
  int axis = -1;     ///< of the exceeded limit; -1 with `motor_limit`: the transmission cannot reach the joints
  double value = 0;  ///< joint or motor position there
};

/// Of all branches of a tool pose (`RobotModel::branches`) and all whole turns of the joints that have a period, the
/// posture within joint and motor limits that is nearest to `near`:
///   distance^2 = sum over the axes of ((q_i - near_i) / velocity_max_i)^2   (s^2)
/// Of equal ones the first branch, its nearest turn. Only when no posture has the pose: the nearest one within the
/// tolerances above, by the branches that a model has projected, or with joints moved back to a limit that they exceed
/// by less than a tolerance.
Posture nearest_posture(const ToolKinematics& kinematics, const Pose& pose, const JointVector& near) noexcept;

/// Whether joints and motors are within their limits, with a tolerance of 1e-9.
bool within_limits(const RobotModel& model, const JointVector& joints) noexcept;

}  // namespace mrroc
