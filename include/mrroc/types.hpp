#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace mrroc {

/// Maximum number of axes of a robot (the original's largest effector drives eight servos).
inline constexpr int kMaxJoints = 8;

/// One value per axis: rad or m, rad/s or m/s, by context. Its storage is inline: copying it never allocates.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxJoints, 1>;

/// Square matrix over the axes, e.g. a reflected inertia. Inline storage.
using JointMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxJoints, kMaxJoints>;

/// Geometric Jacobian: twist of the tool frame's origin, in base axes, per joint velocity. Inline storage.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, kMaxJoints>;

/// Position (m) and orientation of one frame in another.
using Pose = Eigen::Isometry3d;

/// Linear velocity (m/s) in rows 0..2, angular velocity (rad/s) in rows 3..5.
using Twist = Eigen::Matrix<double, 6, 1>;

/// Force (N) in rows 0..2, torque (N m) in rows 3..5.
using Wrench = Eigen::Matrix<double, 6, 1>;

/// Number of a servo tick; tick k happens at epoch + k * servo period. Tick 0 is the start of the deployment.
using Tick = std::uint64_t;

/// "No tick": a wait without a time limit, a start "as soon as possible" is 0.
inline constexpr Tick kNever = ~Tick{0};

/// Names of robots, sensors and processes: at most this many characters, so that they fit a message.
inline constexpr std::size_t kNameLength = 31;

}  // namespace mrroc
