#pragma once

#include "mrroc/types.hpp"

/// Rigid motions of frames. Any thread; never allocates or throws.
namespace mrroc {

/// Whether the pose is a rigid motion: all values finite, R^T R = I within 1e-6, right-handed.
bool is_rigid(const Pose& pose) noexcept;

/// A measured or rounded pose with its rotation made exact: unchanged where `is_rigid`, orthonormalised where R^T R = I
/// within 5e-3. False: the pose is not a rigid transform (scaled, reflected, not finite); it stays as it is.
bool make_rigid(Pose& pose) noexcept;

/// The frame at `position` (m), rotated by `turns` (rad): roll, pitch, yaw about the fixed axes x, y, z in this order,
/// R = Rz(yaw) Ry(pitch) Rx(roll), as in URDF.
Pose pose_from_rpy(const Eigen::Vector3d& position, const Eigen::Vector3d& turns) noexcept;

/// Roll, pitch and yaw (rad) with which `pose_from_rpy` makes this rotation, within rounding for every rotation; where
/// the pitch is +-pi/2, the yaw is one of those that are possible.
Eigen::Vector3d rpy_of(const Eigen::Matrix3d& rotation) noexcept;

/// The same twist of the same point in axes rotated by `rotation`: (R v, R w).
Twist rotate_twist(const Eigen::Matrix3d& rotation, const Twist& twist) noexcept;

/// exp of a twist (times seconds) in body axes: the displacement of a constant screw motion (Lynch and Park, Modern
/// Robotics, eq. 3.88).
Pose exp_twist(const Twist& displacement) noexcept;

/// The rotation by the norm of `vector` (rad) about its direction.
Eigen::Matrix3d exp_rotation(const Eigen::Vector3d& vector) noexcept;
/// Its inverse: the rotation vector of `rotation`, of norm 0..pi.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) noexcept;

/// The rotation nearest to a product of rotations: products drift away from orthonormality.
Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& rotation) noexcept;

}  // namespace mrroc
